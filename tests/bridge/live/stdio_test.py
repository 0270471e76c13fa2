"""The same protocol as JSON lines, for a program that starts the bridge itself."""
import base64
import json
import os
import socket
import subprocess
import time
import unittest

import driver
from driver import eventually, impossible, level_bytes, program
from protocol_test import ended


class StdioTest(unittest.TestCase):
    def setUp(self):
        self.folder = driver.tempfile.mkdtemp(prefix="obby-bridge-")
        self.addCleanup(driver.shutil.rmtree, self.folder)
        self.command = [os.path.join(driver.BIN, "obby-bridge"), "--stdio", "--state-dir",
                        os.path.join(self.folder, "state")]
        self.counter, self.seen = 0, []

    def start(self, *options, **popen):
        process = subprocess.Popen(self.command + list(options), stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, **popen)
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        if process.poll() is None:
            process.kill()
        process.wait()
        process.stdin.close()
        process.stdout.close()

    def call(self, process, method, path, **body):
        self.counter += 1
        line = json.dumps({"id": self.counter, "method": method, "path": path, **body})
        process.stdin.write(line.encode() + b"\n")
        process.stdin.flush()
        while True:
            message = json.loads(process.stdout.readline())
            if message.get("id") == self.counter:
                return message
            self.seen.append(message)

    def place(self, process):
        return self.call(process, "POST", "/v1/levels",
                         text=level_bytes("several-routes.jsonl").decode())["body"]["level"]

    def hear(self, process, wanted):
        """Reads messages until wanted() accepts one, and returns it."""
        while not any(wanted(m) for m in self.seen):
            self.seen.append(json.loads(process.stdout.readline()))
        return next(m for m in self.seen if wanted(m))

    def test_level_job_and_messages(self):
        process = self.start()
        level = self.call(process, "POST", "/v1/levels",
                          base64=base64.b64encode(level_bytes("demo.rbxlx")).decode())
        self.assertEqual(level["status"], 201)
        again = self.call(process, "POST", "/v1/levels",
                          base64=base64.b64encode(level_bytes("demo.rbxlx")).decode())
        self.assertEqual((again["status"], again["body"]["level"]), (200, level["body"]["level"]))
        back = self.call(process, "GET", "/v1/levels/" + level["body"]["level"])
        self.assertTrue(back["text"].startswith('{"type":"level"'))
        job = self.call(process, "POST", "/v1/jobs",
                        body={"level": level["body"]["level"], "ask": ["stage1"]})
        self.assertEqual(job["status"], 202)
        self.hear(process, ended)
        verdicts = [m["record"]["verdict"] for m in self.seen
                    if m.get("type") == "record" and m["record"]["type"] == "result"]
        self.assertEqual(verdicts, ["solved"])
        self.assertEqual([m["number"] for m in self.seen], list(range(1, len(self.seen) + 1)))
        process.stdin.close()
        self.assertEqual(process.wait(20), 0)

    def test_jobs_end_before_the_bridge_does(self):
        lines = [{"id": 1, "method": "POST", "path": "/v1/levels",
                  "text": level_bytes("several-routes.jsonl").decode()}]
        first = subprocess.run(self.command, input=json.dumps(lines[0]).encode(),
                               capture_output=True, check=True)
        level = json.loads(first.stdout)["body"]["level"]
        lines.append({"id": 2, "method": "POST", "path": "/v1/jobs",
                      "body": {"level": level, "ask": ["any"]}})
        path = os.path.join(self.folder, "requests")
        with open(path, "w", encoding="ascii") as file:  # event loops cannot wait for a file
            file.write("\n".join(json.dumps(line) for line in lines))
        with open(path, "rb") as file:
            done = subprocess.run(self.command, stdin=file, capture_output=True, check=True)
        messages = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertTrue(ended(messages[-1]))
        self.assertEqual(messages[-1]["state"], "done")

    def test_a_reader_that_goes_away_ends_all(self):
        process = self.start(stderr=subprocess.DEVNULL)
        self.call(process, "POST", "/v1/jobs",
                  body={"level": self.place(process), "queries": [impossible()],
                        "budget": {"timeLimit": 300}})
        self.ends_when_unread(process)

    def ends_when_unread(self, process):
        self.assertTrue(eventually(lambda: driver.children(process.pid)))
        programs = [pid for pid, _ in driver.children(process.pid)]
        process.stdout.close()
        self.assertEqual(process.wait(60), 141)
        self.assertFalse([pid for pid in programs if os.path.exists(f"/proc/{pid}")])

    def test_a_reader_that_goes_away_ends_what_is_quiet_too(self):
        script = program(self, "cat >/dev/null\nexec sleep 1000\n")
        process = self.start("--solve", script, stderr=subprocess.DEVNULL)
        self.call(process, "POST", "/v1/jobs", body={"level": self.place(process)})
        self.hear(process, lambda m: m.get("state") == "running")  # no message follows this one
        self.ends_when_unread(process)

    def test_who_waits_for_a_quiet_program_is_not_silent(self):
        script = program(self, "cat >/dev/null\nsleep 3\necho '{\"type\":\"end\"}'\n")
        process = self.start("--silence", "0.5", "--grace", "0.5", "--solve", script)
        self.call(process, "POST", "/v1/jobs", body={"level": self.place(process)})
        self.assertEqual(self.hear(process, ended)["state"], "done", self.seen[-1])

    def test_a_record_longer_than_what_is_kept_of_messages_comes_whole(self):
        record = json.dumps({"type": "result", "query": "q", "reason": "x" * (9 << 20)},
                            separators=(",", ":"))
        script = program(self, "cat >/dev/null\ncat \"$0.txt\"\n")
        with open(script + ".txt", "w", encoding="ascii") as file:
            file.write(record + "\n")
        process = self.start("--solve", script)
        self.call(process, "POST", "/v1/jobs", body={"level": self.place(process)})
        self.hear(process, ended)
        self.assertEqual([m["number"] for m in self.seen], list(range(1, len(self.seen) + 1)))
        text = "".join(m["text"] for m in self.seen if m["type"] == "fragment")
        self.assertTrue(text == record, "lost or torn")  # not assertEqual: it would print both

    def test_a_line_that_is_too_long_is_refused_and_passed_over(self):
        process = self.start("--max-body", "1")
        long = b'{"id":1,"text":"' + b"x" * (5 << 20) + b'"}\n'
        process.stdin.write(long)
        process.stdin.flush()
        refused = json.loads(process.stdout.readline())
        self.assertEqual((refused["id"], refused["status"]), (None, 413))
        self.assertEqual(self.call(process, "GET", "/v1/info")["status"], 200)
        self.assertEqual(self.seen, [])

    def test_output_that_is_told_not_to_wait_loses_nothing(self):
        ours, theirs = socket.socketpair()  # inetd, ssh and socat start programs this way
        self.addCleanup(ours.close)
        process = subprocess.Popen(self.command, stdin=theirs, stdout=theirs)
        theirs.close()
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        text = json.dumps({"type": "level", "name": "x" * (2 << 20),
                           "parts": [{"name": "Floor", "size": [40, 1, 40]}],
                           "spawns": [{"position": [0, 1, 0]}]})
        place = {"id": 1, "method": "POST", "path": "/v1/levels", "text": text + "\n"}
        stream = ours.makefile("rwb")
        self.addCleanup(stream.close)
        stream.write(json.dumps(place).encode() + b"\n")
        stream.flush()
        level = json.loads(stream.readline())["body"]["level"]
        stream.write(json.dumps({"id": 2, "method": "GET", "path": "/v1/levels/" + level}).encode())
        stream.write(b"\n")
        stream.flush()
        time.sleep(0.5)  # meanwhile the bridge finds the socket full
        self.assertGreater(len(json.loads(stream.readline())["text"]), 2 << 20)

    def test_nonsense_is_answered_and_survived(self):
        process = self.start()
        for line in (b"nonsense", b"[]", b"{}", b'{"id":[1]}', b"\xff\xfe", b"[" * 100000,
                     b'{"method":"GET","path":"/v1/events"}'):
            process.stdin.write(line + b"\n")
            process.stdin.flush()
            answer = json.loads(process.stdout.readline())
            self.assertGreaterEqual(answer["status"], 400, line)
            self.assertTrue(answer["body"]["error"])
        self.assertEqual(self.call(process, "GET", "/v1/info")["status"], 200)

    def test_options_of_servers_do_not_go_with_it(self):
        for option in (["--pair"], ["--no-token"], ["--port", "0"]):
            done = subprocess.run(self.command + option, input=b"", capture_output=True, check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn(b"--stdio: cannot be combined with " + option[0].encode(), done.stderr)

    def test_a_configuration_that_says_nothing_new_goes_with_it(self):
        config = os.path.join(self.folder, "config")
        with open(config, "wb") as file:
            subprocess.run(self.command[:1] + ["--print-config"], stdout=file, check=True)
        done = subprocess.run(self.command + ["--config", config], input=b"", capture_output=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, b""))


if __name__ == "__main__":
    driver.main()
