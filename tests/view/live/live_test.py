"""Tests obby-view --live from outside: hostile requests, pages that come, go and read slowly, and
the end. Run it as `live_test.py BIN_DIR LEVELS_DIR`, with tests/bridge/live in PYTHONPATH."""
import http.client
import itertools
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

import driver
from driver import eventually, exchange

LEVEL = (b'{"type":"level","name":"L","spawns":[{"position":[0,0,0]}],'
         b'"parts":[{"name":"Floor","position":[0,-0.5,0],"size":[20,1,20]}]}\n')
QUERY = b'{"type":"query","id":"q","level":"L","goal":{"position":[0,2,-8],"size":[4,4,4]}}\n'


class Viewer:
    def __init__(self, *options, stdin=subprocess.PIPE):
        self.process = subprocess.Popen([os.path.join(driver.BIN, "obby-view"), "--live", *options],
                                        stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        line = self.process.stderr.readline().decode()
        found = re.fullmatch(r"obby-view: http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{64})\n", line)
        assert found, line
        self.port, self.token = int(found[1]), found[2]

    def write(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def get(self, path, more=""):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            connection.request("GET", f"{path}?token={self.token}{more}")
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()
        finally:
            connection.close()

    def data(self, revision=0):
        return json.loads(self.get("/data", f"&from={revision}")[2])

    def socket(self):
        return socket.create_connection(("127.0.0.1", self.port), timeout=60)

    def listen(self):
        """Returns a connection to /events, and the bytes up to its first event."""
        connection = self.socket()
        try:
            return connection, self.begin_events(connection)
        except (AssertionError, OSError):
            connection.close()
            raise

    def begin_events(self, connection):
        connection.sendall(f"GET /events?token={self.token} HTTP/1.1\r\n"
                           f"Host: 127.0.0.1:{self.port}\r\n\r\n".encode())
        seen = b""
        while b"retry:" not in seen:
            more = connection.recv(4096)
            assert more, seen
            seen += more
        return seen

    def end(self, number=signal.SIGINT):
        """Ends the viewer. Returns its exit code and its output on stderr."""
        if number:
            self.process.send_signal(number)
        try:
            self.process.wait(60)  # first, since closing its input would end the stream
            said = self.process.communicate()[1]
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        return self.process.returncode, said.decode()

    def close_input(self):
        self.process.stdin.close()
        self.process.stdin = None


class HostileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.viewer = Viewer()
        cls.viewer.write(LEVEL)

    @classmethod
    def tearDownClass(cls):
        cls.viewer.end()

    def send(self, method, target, headers, body=b""):
        lines = "".join(f"{name}: {value}\r\n" for name, value in headers if value is not None)
        with self.viewer.socket() as connection:
            return exchange(connection, f"{method} {target} HTTP/1.1\r\n{lines}\r\n", body)

    def cases(self):
        port, token = self.viewer.port, self.viewer.token
        hosts = [(f"127.0.0.1:{port}", 0), (f"localhost:{port}", 0), ("127.0.0.1", 421), (None, 421),
                 (f"evil.example:{port}", 421), (f"127.0.0.1:{port + 1}", 421)]
        origins = [(None, 0), (f"http://127.0.0.1:{port}", 0), ("null", 403), ("", 403),
                   ("http://evil.example", 403), (f"http://127.0.0.1:{port + 1}", 403)]
        sites = [(None, 0), ("same-origin", 0), ("same-site", 403), ("cross-site", 403)]
        flipped = "0" if token[0] != "0" else "1"
        tokens = [(token, 0), ("", 403), (None, 403), (token[1:], 403), (flipped + token[1:], 403)]
        asked = [("GET", "/data", 0), ("POST", "/data", 405), ("GET", "/none", 404),
                 ("DELETE", "/events", 405)]
        for host, origin, site, given, (method, path, status) in itertools.product(
                hosts, origins, sites, tokens, asked):
            wrong = [s for s in (host[1], origin[1] or site[1], given[1], status) if s]
            target = path if given[0] is None else f"{path}?token={given[0]}"
            headers = [("Host", host[0]), ("Origin", origin[0]), ("Sec-Fetch-Site", site[0]),
                       ("Connection", "close")]
            yield (wrong or [200])[0], method, target, headers

    def test_only_honest_requests_pass(self):
        count = 0
        for status, method, target, headers in self.cases():
            self.assertEqual(self.send(method, target, headers), status, (method, target, headers))
            count += status != 200
        sys.stderr.write(f"{count} hostile requests refused ... ")
        self.assertGreater(count, 2000)

    def test_refusals_tell_nothing(self):
        with self.viewer.socket() as connection:
            connection.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{self.viewer.port}\r\n"
                               "Connection: close\r\n\r\n".encode())
            answer = b"".join(iter(lambda: connection.recv(65536), b""))
        head, _, body = answer.partition(b"\r\n\r\n")
        self.assertTrue(head.startswith(b"HTTP/1.1 403 "), head)
        self.assertLess(len(body), 100)
        self.assertNotIn(self.viewer.token.encode(), answer)
        self.assertNotIn(b"Access-Control", answer)

    def test_the_page_is_not_to_be_framed_kept_or_guessed_at(self):
        status, headers, body = self.viewer.get("/")
        self.assertEqual(status, 200)
        self.assertEqual(headers["Content-Security-Policy"], "frame-ancestors 'none'")
        self.assertEqual(headers["Referrer-Policy"], "no-referrer")
        self.assertEqual(headers["Cache-Control"], "no-store")
        self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
        self.assertNotIn("Access-Control-Allow-Origin", headers)
        self.assertIn(b"default-src 'none'; connect-src 'self';", body)
        self.assertNotIn(self.viewer.token.encode(), body)

    def test_what_is_too_large_or_no_http_is_refused(self):
        host = [("Host", f"127.0.0.1:{self.viewer.port}")]
        target = f"/data?token={self.viewer.token}"
        large = [*host, ("Content-Length", "1000000000")]
        self.assertIn(self.send("POST", target, large, b"x" * 100000), (405, None))
        endless = f"/data?token={self.viewer.token}&from=" + "1" * 200000
        self.assertIn(self.send("GET", endless, host), (400, 414, 431, None))
        for text in ("\x16\x03\x01\x02\x00\r\n\r\n", "GET\r\n\r\n", "\0" * 100 + "\r\n\r\n"):
            with self.viewer.socket() as connection:
                self.assertIn(exchange(connection, text), (400, 421, 501, 505, None), text)
        self.assertEqual(self.viewer.get("/")[0], 200)

    def test_it_listens_on_the_loopback_interface_alone(self):
        with open(f"/proc/{self.viewer.process.pid}/net/tcp", encoding="ascii") as file:
            local = [line.split()[1] for line in file if line.split()[3] == "0A"]
        port = f"{self.viewer.port:04X}"
        self.assertEqual([each for each in local if each.endswith(port)], [f"0100007F:{port}"])


class PagesTest(unittest.TestCase):
    def test_events_tell_of_newer_data(self):
        viewer = Viewer()
        connection, seen = viewer.listen()
        viewer.write(LEVEL)
        while b'"revision":1}' not in seen:
            seen += connection.recv(4096)
        self.assertTrue(eventually(lambda: viewer.data()["levels"]))
        viewer.write(QUERY)
        while b'"revision":2}' not in seen:
            seen += connection.recv(4096)
        news = viewer.data(1)
        self.assertEqual((len(news["levels"]), len(news["queries"])), (0, 1))
        connection.close()
        self.assertEqual(viewer.end()[0], 130)

    def test_at_most_five_revisions_a_second(self):
        viewer = Viewer()
        viewer.write(LEVEL)
        begun, count = time.monotonic(), 0
        while time.monotonic() < begun + 1:
            viewer.write(QUERY.replace(b'"q"', f'"q{count}"'.encode()))
            count += 1
            time.sleep(0.005)
        self.assertTrue(eventually(lambda: len(viewer.data()["queries"]) == count))
        passed = time.monotonic() - begun
        self.assertLessEqual(viewer.data()["revision"], 5 * passed + 2)
        viewer.end()

    def test_twice_the_pages_that_it_takes_come_and_go(self):
        viewer = Viewer()
        viewer.write(LEVEL)
        for i in range(70):
            connection = self.listen_when_there_is_space(viewer)
            if i % 2:  # with a reset
                connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
            connection.close()
        descriptors = f"/proc/{viewer.process.pid}/fd"
        self.assertTrue(eventually(lambda: len(os.listdir(descriptors)) < 20))
        self.assertEqual(viewer.get("/")[0], 200)
        viewer.end()

    def test_more_pages_than_it_takes_are_turned_away(self):
        viewer = Viewer()
        open_ = [viewer.listen()[0] for _ in range(32)]
        with viewer.socket() as connection:
            self.assertEqual(connection.recv(100), b"")
        for each in open_:
            each.close()
        self.assertTrue(eventually(lambda: self.passes(viewer)))
        viewer.end()

    def listen_when_there_is_space(self, viewer):
        """Waits for a free connection. A closed page keeps its place for a second or two."""
        found = []

        def listens():
            try:
                found.append(viewer.listen()[0])
            except (AssertionError, OSError):
                pass
            return found

        self.assertTrue(eventually(listens))
        return found[0]

    def passes(self, viewer):
        try:
            return viewer.get("/")[0] == 200
        except (http.client.HTTPException, OSError):
            return False

    def test_who_reads_slowly_holds_nobody_up(self):
        viewer = Viewer()
        parts = ",".join(f'{{"name":"Part {i}","position":[{i},0,0],"size":[1,1,1]}}'
                         for i in range(40000))
        viewer.write(f'{{"type":"level","name":"L","spawns":[{{"position":[0,0,0]}}],"parts":[{parts}]}}\n'.encode())
        self.assertTrue(eventually(lambda: viewer.data()["levels"]))
        slow = viewer.socket()
        slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        slow.sendall(f"GET /data?token={viewer.token} HTTP/1.1\r\n"
                     f"Host: 127.0.0.1:{viewer.port}\r\n\r\n".encode())
        listener, seen = viewer.listen()
        begun = time.monotonic()
        viewer.write(QUERY)
        while b'"revision":2}' not in seen:
            seen += listener.recv(4096)
        self.assertLess(time.monotonic() - begun, 30)
        slow.close()
        listener.close()
        self.assertEqual(viewer.end()[0], 130)


class EndTest(unittest.TestCase):
    def test_it_ends_by_itself_only_if_it_is_to_and_once_no_page_is_open(self):
        """All viewers wait together, for longer than it takes to notice that a page is gone."""
        leaving = Viewer("--live-exit")
        staying = [(Viewer(), number, code)
                   for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143))]
        viewers = [leaving, *(viewer for viewer, _, _ in staying)]
        for viewer in viewers:
            viewer.write(LEVEL)
        connection, _ = leaving.listen()
        for viewer in viewers:
            viewer.close_input()
            self.assertTrue(eventually(lambda: viewer.data()["head"]["state"] == "ended"))
        time.sleep(3)
        for viewer in viewers:
            self.assertIsNone(viewer.process.poll())
        connection.close()
        for viewer, number, code in staying:
            self.assertEqual(viewer.end(number), (code, ""))
        self.assertEqual(leaving.end(0), (0, ""))

    def test_it_stops_at_once_while_the_stream_runs(self):
        viewer = Viewer()
        viewer.write(LEVEL)
        begun = time.monotonic()
        self.assertEqual(viewer.end()[0], 130)
        self.assertLess(time.monotonic() - begun, 15)

    def test_the_file_is_written_when_the_stream_ends_or_is_interrupted(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "report.html")
            viewer = Viewer("-o", path)
            viewer.write(LEVEL + QUERY)
            self.assertTrue(eventually(lambda: viewer.data()["queries"]))
            self.assertFalse(os.path.exists(path))
            viewer.close_input()
            self.assertTrue(eventually(lambda: os.path.exists(path)))
            with open(path, encoding="utf-8") as file:
                self.assertIn('"id":"q"', file.read())
            viewer.end()
            os.remove(path)
            viewer = Viewer("-o", path)
            viewer.write(LEVEL + QUERY)
            self.assertTrue(eventually(lambda: viewer.data()["queries"]))
            self.assertEqual(viewer.end()[0], 130)
            with open(path, encoding="utf-8") as file:
                self.assertIn("was interrupted", file.read())

    def test_a_malformed_record_is_said_at_once_and_it_stays(self):
        viewer = Viewer()
        viewer.write(LEVEL + b'{"type":"query","id":7}\n')
        self.assertIn(b"obby-view: stdin:2: id: expected", viewer.process.stderr.readline())
        data = viewer.data
        self.assertTrue(eventually(lambda: data()["head"]["state"] == "broken"))
        self.assertIn("stdin:2", data()["head"]["notes"][0])
        self.assertEqual(len(data()["levels"]), 1)
        self.assertEqual(viewer.end()[0], 2)

    def test_behind_a_record_that_stops_it_the_rest_is_taken(self):
        """Otherwise the solver before it in the pipe would block while the page is open."""
        viewer = Viewer()
        viewer.write(LEVEL + QUERY.replace(b'"goal"', b'"start":{"spawn":5},"goal"'))
        self.assertIn(b"obby-view: stdin:2: start.spawn: expected",
                      viewer.process.stderr.readline())
        more = b'{"type":"query","id":7}\n' + QUERY * 5000  # much more than a pipe holds
        pipe, rest = viewer.process.stdin.fileno(), [more]
        os.set_blocking(pipe, False)

        def taken():
            try:
                rest[0] = rest[0][os.write(pipe, rest[0]):]
            except BlockingIOError:
                pass
            return not rest[0]

        self.assertTrue(eventually(taken))
        self.assertTrue(eventually(lambda: viewer.data()["head"]["state"] == "broken"))
        self.assertEqual(len(viewer.data()["queries"]), 1)
        self.assertEqual(viewer.end()[0], 2)

    def test_skipped_records_are_said_and_the_rest_comes(self):
        viewer = Viewer("--on-error", "skip")
        viewer.write(LEVEL + b'{"type":"query","id":7}\n' + QUERY)
        self.assertTrue(eventually(lambda: viewer.data()["queries"]))
        self.assertEqual(viewer.data()["head"]["state"], "live")
        self.assertEqual(viewer.end()[0], 2)

    def test_all_encodings_are_read(self):
        level = os.path.join(driver.LEVELS, "goal-too-high.jsonl")
        for name in ("capnp", "packed", "jsonl"):
            solver = subprocess.run([os.path.join(driver.BIN, "obby-solve"), "--format", name, level],
                                    capture_output=True, check=True)
            viewer = Viewer()
            viewer.write(solver.stdout)
            viewer.close_input()
            self.assertTrue(eventually(lambda: viewer.data()["head"]["state"] == "ended"), name)
            data = viewer.data()
            self.assertEqual(data["queries"][0]["facts"]["result"]["verdict"], "unreachable", name)
            viewer.end()


if __name__ == "__main__":
    driver.main(groups=2)
