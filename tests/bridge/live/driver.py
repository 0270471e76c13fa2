"""Starts an obby-bridge for a test and talks to it by HTTP, WebSockets and raw bytes. It uses only
Python's standard library. Every test file runs as `NAME_test.py BIN_DIR LEVELS_DIR`."""
import base64
import http.client
import json
import os
import select
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

BIN, LEVELS = None, None


def main(groups=1):
    """Runs the tests of the file, or only the named ones. Tests that mostly wait can run in several
    groups at the same time."""
    global BIN, LEVELS
    # The test files import this module by its name and get the same object, with these two
    # folders.
    BIN, LEVELS = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    names = sys.argv[3:]
    if groups > 1 and not names:
        sys.exit(run_groups(groups))
    unittest.main(module="__main__", argv=sys.argv[:1] + names, verbosity=2)


def run_groups(count):
    """Runs all tests, each group in its own process. Returns 0 if none has failed."""
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
    names = [test.id().partition(".")[2] for case in suite for test in case]
    processes = [subprocess.Popen([sys.executable, *sys.argv[:3], *names[first::count]],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                 for first in range(min(count, len(names)))]
    for process in processes:
        print(process.communicate()[0].decode(errors="replace"), flush=True)
    return max(abs(process.returncode) for process in processes)


def level_bytes(name):
    with open(os.path.join(LEVELS, name), "rb") as file:
        return file.read()


def impossible():
    """Returns a query without a solution or a proof: a search runs until its time is up."""
    return {"goal": {"position": [0, 3, -68], "size": [20, 6, 10]}, "maxJumps": 1,
            "forbid": ["fallingDown"], "id": "endless", "maxDamage": 0,
            "waypoints": [{"region": {"position": [-14, 3, -30], "size": [6, 6, 6]}}]}


def children(pid):
    """Returns the living child processes of `pid`, as (pid, command line)."""
    out = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        try:
            with open(f"/proc/{entry}/stat", "rb") as file:
                fields = file.read().rpartition(b")")[2].split()
            if int(fields[1]) == pid:
                with open(f"/proc/{entry}/cmdline", "rb") as file:
                    out.append((int(entry), file.read().replace(b"\0", b" ").decode()))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return out


def program(test, text):
    """Writes a shell script that stands in for obby-solve until the test ends. Returns its path."""
    folder = tempfile.mkdtemp(prefix="obby-bridge-")
    test.addCleanup(shutil.rmtree, folder)
    path = os.path.join(folder, "solve")
    with open(path, "w", encoding="ascii") as file:
        file.write("#!/bin/sh\n" + text)
    os.chmod(path, 0o755)
    return path


def sanitized():
    """Returns true if the tools have sanitizers, which take unlimited address space."""
    config = subprocess.run([os.path.join(BIN, "obby-bridge"), "--print-config"],
                            capture_output=True, check=True).stdout.decode()
    return "memory = 0" in config


def eventually(what, seconds=60):
    """Returns true if what() becomes true within this time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if what():
            return True
        time.sleep(0.02)
    return what()


class Answer:
    def __init__(self, status, headers, body):
        self.status, self.headers, self.body = status, headers, body

    def json(self):
        return json.loads(self.body)


class Bridge:
    """A bridge on a free port with its own folder, and one paired client."""

    def __init__(self, *options, pair=True, state=None, folder=None, **popen):
        self.folder = tempfile.mkdtemp(prefix="obby-bridge-")
        self.state = state or os.path.join(self.folder, "state")
        command = [os.path.join(folder or BIN, "obby-bridge"), "--port", "0", "--state-dir", self.state]
        command += (["--pair"] if pair else []) + list(options)
        environment = {k: v for k, v in os.environ.items() if not k.startswith("OBBY_")}
        self.errors = open(os.path.join(self.folder, "stderr"), "w+b")
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=self.errors,
                                        env=environment, **popen)
        first = self.process.stdout.readline().decode()
        if "http://127.0.0.1:" not in first:
            raise RuntimeError(f"obby-bridge did not start: {self.said()}")
        self.port = int(first.rpartition(":")[2])
        self.token = None
        if pair:
            self.code = self.shown_code()
            self.token = self.post("/v1/pair", {"code": self.code}, token=None).json()["token"]

    def shown_code(self):
        """Returns the code that --pair prints. Call it once."""
        return self.process.stdout.readline().decode().rpartition(": ")[2].strip()

    def said(self):
        self.errors.seek(0)
        return self.errors.read().decode(errors="replace")

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            try:
                self.process.wait(60)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.process.stdout.close()
        self.errors.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def jobs_running(self):
        return children(self.process.pid)

    # --- HTTP

    OWN = object()

    def request(self, method, path, body=None, headers=None, token=OWN, timeout=120):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            headers = dict(headers or {})
            if token is Bridge.OWN:
                token = self.token
            if token:
                headers["Authorization"] = "Bearer " + token
            connection.request(method, path, body=body, headers=headers)
            response = connection.getresponse()
            return Answer(response.status, dict(response.getheaders()), response.read())
        finally:
            connection.close()

    def get(self, path, **more):
        return self.request("GET", path, **more)

    def delete(self, path, **more):
        return self.request("DELETE", path, **more)

    def post(self, path, value, **more):
        return self.request("POST", path, json.dumps(value).encode(),
                            {"Content-Type": "application/json"}, **more)

    def place(self, data, kind="application/x-ndjson", **headers):
        return self.request("POST", "/v1/levels", data, {"Content-Type": kind, **headers})

    def place_level(self, name):
        answer = self.place(level_bytes(name))
        assert answer.status in (200, 201), answer.body
        return answer.json()["level"]

    def ask(self, **order):
        answer = self.post("/v1/jobs", order)
        assert answer.status == 202, answer.body
        return answer.json()

    def messages(self, job, cursor=None, until=lambda m: False, seconds=180):
        """Returns a job's messages from long polls until it ends or until() accepts a message."""
        out, end = [], time.monotonic() + seconds
        while time.monotonic() < end:
            query = "?wait=5" + (f"&cursor={cursor}" if cursor is not None else "")
            answer = self.get(f"/v1/jobs/{job}{query}")
            assert answer.status == 200, answer.body
            part = answer.json()
            out += part["messages"]
            cursor = part["cursor"]
            ended = part["state"] in ("done", "cancelled", "failed") and not part["more"]
            if ended or any(until(m) for m in part["messages"]):
                return out
        raise AssertionError(f"job {job} did not end")

    # --- WebSocket

    def socket(self, timeout=60):
        return socket.create_connection(("127.0.0.1", self.port), timeout=timeout)

    def events(self, query="", **headers):
        return WebSocket(self, query, headers)


def exchange(connection, head, body=b""):
    """Sends a raw request. Returns the status of the answer, or None if there is no answer."""
    try:
        connection.sendall(head.encode() + body)
        answer = connection.recv(65536)
    except (ConnectionResetError, BrokenPipeError):
        return None
    return int(answer.split(b" ", 2)[1]) if answer.startswith(b"HTTP/1.1 ") else None


class WebSocket:
    def __init__(self, bridge, query="", headers=None):
        self.socket, self.data = bridge.socket(), b""
        fields = {"Host": f"127.0.0.1:{bridge.port}", "Upgrade": "websocket",
                  "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                  "Sec-WebSocket-Key": base64.b64encode(os.urandom(16)).decode(),
                  "Authorization": f"Bearer {bridge.token}", **(headers or {})}
        lines = "".join(f"{name}: {value}\r\n" for name, value in fields.items())
        self.socket.sendall(f"GET /v1/events{query} HTTP/1.1\r\n{lines}\r\n".encode())
        while b"\r\n\r\n" not in self.data:
            more = self.socket.recv(65536)
            if not more:
                break
            self.data += more
        head, _, self.data = self.data.partition(b"\r\n\r\n")
        self.status = int(head.split(b" ", 2)[1])

    def take(self, count):
        while len(self.data) < count:
            more = self.socket.recv(65536)
            if not more:
                raise ConnectionError("closed")
            self.data += more
        out, self.data = self.data[:count], self.data[count:]
        return out

    def receive(self):
        """Returns the next message, or ("close", code) for a close frame."""
        first, length = self.take(2)
        if length == 126:
            length = struct.unpack(">H", self.take(2))[0]
        elif length == 127:
            length = struct.unpack(">Q", self.take(8))[0]
        payload = self.take(length)
        if first & 15 == 8:
            return ("close", struct.unpack(">H", payload[:2])[0])
        return json.loads(payload)

    def until(self, wanted, seconds=120):
        """Returns the messages up to the first one that wanted() accepts."""
        out, end = [], time.monotonic() + seconds
        while time.monotonic() < end:
            message = self.receive()
            out.append(message)
            if isinstance(message, tuple) or wanted(message):
                return out
        raise AssertionError("the message did not come")

    def send(self, text, opcode=1):
        mask, data = os.urandom(4), text if isinstance(text, bytes) else text.encode()
        size = struct.pack(">BB", 128 | opcode, 128 | len(data)) if len(data) < 126 else \
            struct.pack(">BBH", 128 | opcode, 254, len(data))
        self.socket.sendall(size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(data)))

    def silent_for(self, seconds):
        """Returns true if nothing arrives for this time."""
        return not self.data and not select.select([self.socket], [], [], seconds)[0]

    def close(self):
        self.socket.close()
