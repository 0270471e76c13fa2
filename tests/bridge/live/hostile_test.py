"""Requests that the bridge must refuse: all combinations of Host, Origin, token, content type,
method and WebSocket in which at least one is wrong, and false or malformed bodies."""
import gzip
import itertools
import json
import os
import sys
import unittest

import driver
from driver import Bridge, exchange

BODY = json.dumps({"level": "0" * 32}).encode()


class HostileTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # This program leaves a trace if a hostile request starts it.
        cls.folder = driver.tempfile.mkdtemp(prefix="obby-bridge-")
        cls.trace = os.path.join(cls.folder, "started")
        cls.program = os.path.join(cls.folder, "solve")
        with open(cls.program, "w", encoding="ascii") as file:
            file.write(f"#!/bin/sh\ntouch {cls.trace}\ncat >/dev/null\n")
        os.chmod(cls.program, 0o755)
        cls.bridge = Bridge("--solve", cls.program)
        cls.level = cls.bridge.place_level("several-routes.jsonl")

    @classmethod
    def tearDownClass(cls):
        cls.bridge.close()
        driver.shutil.rmtree(cls.folder)

    def send(self, method, path, headers, body=b""):
        lines = "".join(f"{name}: {value}\r\n" for name, value in headers if value is not None)
        with self.bridge.socket() as connection:
            return exchange(connection, f"{method} {path} HTTP/1.1\r\n{lines}\r\n", body)

    def nothing_happened(self):
        self.assertEqual(self.bridge.jobs_running(), [])
        self.assertFalse(os.path.exists(self.trace), "a program was started")
        self.assertEqual(self.bridge.get("/v1/info").json()["jobs"], [])

    # These lists contain pairs of a value and the status of a request in which only that value is
    # wrong (None: the value is valid).
    def hosts(self):
        port = self.bridge.port
        return [(f"127.0.0.1:{port}", None), (f"LOCALHOST:{port}", None), (f"[::1]:{port}", None),
                ("127.0.0.1", 421), (f"evil.example:{port}", 421), (f"127.0.0.1:{port + 1}", 421),
                (f"127.0.0.1:{port}.evil.example", 421), (f"127.0.0.1:{port}, evil", 421),
                ("", 421), (None, 421)]

    def origins(self):
        return [(None, None), ("http://evil.example", 403), ("null", 403),
                (f"http://127.0.0.1:{self.bridge.port}", 403), ("file://", 403), ("", 403)]

    def tokens(self):
        good = self.bridge.token
        return [(f"Bearer {good}", None), (None, 401), ("Bearer ", 401), (f"Basic {good}", 401),
                (f"Bearer {good[:-1]}", 401), (f"Bearer {good}0", 401),
                (f"Bearer {good[:-1]}{'0' if good[-1] != '0' else '1'}", 401), (good, 401)]

    def requests(self):
        """Returns (method, path, content type, upgrade, status), where status None is valid."""
        return [("POST", "/v1/jobs", "application/json", False, None),
                ("POST", "/v1/jobs", "text/plain", False, 415),
                ("POST", "/v1/jobs", "application/x-www-form-urlencoded", False, 415),
                ("POST", "/v1/jobs", "multipart/form-data; boundary=x", False, 415),
                ("POST", "/v1/jobs", None, False, 415),
                ("PUT", "/v1/jobs", "application/json", False, 405),
                ("GET", "/v1/jobs", "application/json", False, 405),
                ("OPTIONS", "/v1/jobs", "application/json", False, 405),
                ("POST", "/v1/jobs", "application/json", True, 400),
                ("GET", "/v1/events", None, True, None),
                ("GET", "/v1/events", None, False, 426)]

    def cases(self):
        for host, origin, token, request in itertools.product(
                self.hosts(), self.origins(), self.tokens(), self.requests()):
            wrong = [status for status in (host[1], origin[1], token[1], request[4]) if status]
            if wrong:
                yield wrong[0], host[0], origin[0], token[0], request

    def test_no_hostile_request_passes(self):
        count = 0
        for status, host, origin, token, (method, path, kind, upgrade, _) in self.cases():
            headers = [("Host", host), ("Origin", origin), ("Authorization", token),
                       ("Content-Type", kind), ("Connection", "close")]
            body = BODY.replace(b"0" * 32, self.level.encode()) if method != "GET" else b""
            if upgrade:
                headers[-1:] = [("Connection", "Upgrade"), ("Upgrade", "websocket"),
                                ("Sec-WebSocket-Version", "13"),
                                ("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ==")]
            if body:
                headers.append(("Content-Length", str(len(body))))
            found = self.send(method, path, headers, body)
            self.assertEqual(found, status, (host, origin, token, method, path, kind, upgrade))
            count += 1
        self.nothing_happened()
        sys.stderr.write(f"{count} hostile requests refused ... ")
        self.assertGreaterEqual(count, 60)

    def test_the_honest_ones_of_the_matrix_do_pass(self):
        job = self.bridge.post("/v1/jobs", {"level": "0" * 32})
        self.assertEqual(job.status, 404)  # passes all checks, but there is no such level
        events = self.bridge.events()
        self.assertEqual(events.status, 101)
        events.close()

    def honest(self, *more):
        return [("Host", f"127.0.0.1:{self.bridge.port}"),
                ("Authorization", f"Bearer {self.bridge.token}"), *more]

    def test_browsers_are_known_by_their_fetch_headers(self):
        for value in ("cross-site", "same-origin", "none", ""):
            self.assertEqual(
                self.send("GET", "/v1/info", self.honest(("Sec-Fetch-Site", value))), 403)

    def test_headers_given_twice_do_not_help(self):
        first, token = self.honest()
        self.assertEqual(self.send("GET", "/v1/info", [first, ("Host", "evil"), token]), 421)
        self.assertEqual(self.send("GET", "/v1/info", [first, ("Authorization", "Bearer x"), token]),
                         401)

    def test_odd_addresses_lead_nowhere(self):
        for path, status in [
                ("/", 404), ("/v1", 404), ("/v1/info/", 404), ("/v1/levels/../../etc/passwd", 404),
                ("/v1/levels/%2e%2e%2f", 404), ("/v1/levels/" + "A" * 32, 404),
                ("/v1/jobs/j", 404), ("/v1/jobs/j1/../j2", 404), ("/v1/jobs/" + "j1" * 300, 400),
                ("http://127.0.0.1/v1/info", 400), ("/v1/jobs/j1?cursor=-1", 400),
                ("/v1/jobs/j1?cursor=99999999999999999999", 400), ("/v1/jobs/j1?cursor=1e3", 400),
                ("/v1/jobs/j1?wait=1&wait=2", 400), ("/v1/jobs/j1?out=/tmp/x", 400),
                ("/v1/info?token=" + self.bridge.token, 400), ("/v1/jobs/j77", 404)]:
            self.assertEqual(self.send("GET", path, self.honest()), status, path)
        for method in ("BREW", "CONNECT"):
            self.assertIn(self.send(method, "/v1/info", self.honest()), (501, 400, 404, 405), method)
        self.nothing_happened()

    def test_http_that_is_none_is_refused(self):
        for text in ("\x16\x03\x01\x02\x00\r\n\r\n", "GET\r\n\r\n", "GET /v1/info\r\n\r\n",
                     "POST /v1/jobs HTTP/1.1\r\nContent-Length: -5\r\n\r\n", "\0" * 100 + "\r\n\r\n"):
            with self.bridge.socket() as connection:
                self.assertIn(exchange(connection, text), (400, 421, 501, 505, None), text)
        self.nothing_happened()

    def test_bodies_that_lie_start_nothing(self):
        deep = b"[" * 200000 + b"]" * 200000
        for body, status in [(b"", 400), (b"{", 400), (b"null", 400), (b"[]", 400), (deep, 400),
                             (b'{"level":"%s","level":"x"}' % self.level.encode(), 400),
                             (b'{"level":"\xff\xfe"}', 400), (b'{"budget":' + b"9" * 400 + b"}", 400),
                             (b'{"level":"%s","ask":["--help"]}' % self.level.encode(), 404)]:
            headers = self.honest(("Content-Type", "application/json"),
                                  ("Content-Length", str(len(body))))
            self.assertEqual(self.send("POST", "/v1/jobs", headers, body), status, body[:60])
        self.nothing_happened()

    def test_the_pairing_code_cannot_be_guessed(self):
        other = Bridge(pair=False, state=self.bridge.state)  # this bridge offers no code
        try:
            self.assertEqual(other.post("/v1/pair", {"code": "AAAA-AAAA"}, token=None).status, 403)
        finally:
            other.close()
        # A code works only once.
        self.assertEqual(self.bridge.post("/v1/pair", {"code": self.bridge.code}, token=None).status,
                         403)
        for _ in range(8):
            answer = self.bridge.post("/v1/pair", {"code": "AAAAAAAA"}, token=None)
            self.assertEqual(answer.status, 403)

    def test_strangers_can_make_it_keep_little(self):
        other = Bridge("--pair", pair=False)
        self.addCleanup(other.close)
        code = other.shown_code()
        kind = {"Content-Type": "application/json"}
        large = b'{"code":"' + b"A" * (1 << 20) + b'"}'
        for body in (large, iter([large])):  # once with its length in the head, once in chunks
            answer = other.request("POST", "/v1/pair", body, kind, token=None)
            self.assertEqual(answer.status, 413)
            self.assertIn("4 KiB", answer.json()["error"])
        packed = other.request("POST", "/v1/pair", gzip.compress(large),
                               {**kind, "Content-Encoding": "gzip"}, token=None)
        self.assertEqual(packed.status, 415)
        # None of these requests counted as an attempt to pair.
        self.assertEqual(other.post("/v1/pair", {"code": code}, token=None).status, 200)

    def test_where_no_code_is_on_offer_none_is_read(self):
        headers = [("Host", f"127.0.0.1:{self.bridge.port}"), ("Content-Type", "application/json")]
        for length in (1000, 1 << 40):  # lengths of bodies that never arrive
            self.assertEqual(
                self.send("POST", "/v1/pair", headers + [("Content-Length", str(length))]), 403)

    def test_one_websocket_a_client(self):
        first = self.bridge.events()
        second = self.bridge.events()
        self.assertEqual((first.status, second.status), (101, 409))
        first.close()
        second.close()


if __name__ == "__main__":
    driver.main()
