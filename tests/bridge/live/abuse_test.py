"""The bridge survives slow, greedy and vanished clients, killed programs and full disks. It reports
what happened and leaves no process behind."""
import gzip
import http.client
import json
import os
import resource
import signal
import time
import unittest

import driver
from driver import Bridge, eventually, exchange, impossible, level_bytes, program

LEVEL = "several-routes.jsonl"


class AbuseTest(unittest.TestCase):
    def bridge(self, *options, **more):
        out = Bridge(*options, **more)
        self.addCleanup(out.close)
        return out

    def endless(self, bridge):
        level = bridge.place_level(LEVEL)
        job = bridge.ask(level=level, queries=[impossible()], budget={"timeLimit": 300})["job"]
        self.assertTrue(eventually(bridge.jobs_running))
        return job

    def head(self, bridge, path, *lines):
        fields = [f"Host: 127.0.0.1:{bridge.port}", f"Authorization: Bearer {bridge.token}", *lines]
        return f"POST {path} HTTP/1.1\r\n" + "\r\n".join(fields) + "\r\n\r\n"

    # --- size

    def test_large_bodies_are_refused_before_they_are_read(self):
        bridge = self.bridge("--max-body", "1")
        head = self.head(bridge, "/v1/levels", "Content-Type: application/octet-stream",
                         "Content-Length: 1099511627776")
        with bridge.socket() as connection:
            self.assertEqual(exchange(connection, head), 413)
        chunked = self.head(bridge, "/v1/levels", "Content-Type: application/octet-stream",
                            "Transfer-Encoding: chunked")
        with bridge.socket() as connection:
            chunk = b"10000\r\n" + b"x" * 0x10000 + b"\r\n"
            self.assertIn(exchange(connection, chunked, chunk * 20), (413, None))
        self.assertEqual(bridge.get("/v1/info").status, 200)

    def test_who_is_still_sending_is_told_why_it_is_refused(self):
        bridge = self.bridge("--max-body", "1")
        head = self.head(bridge, "/v1/levels", "Content-Type: application/octet-stream",
                         f"Content-Length: {8 << 20}")
        with bridge.socket() as connection:
            connection.sendall(head.encode())
            for _ in range(32):
                connection.sendall(b"x" * (256 << 10))
                time.sleep(0.005)
            self.assertEqual(exchange(connection, ""), 413)

    def test_gzip_bombs_are_refused(self):
        bridge = self.bridge("--max-body", "1")
        bomb = gzip.compress(b"\0" * (64 << 20))
        self.assertLess(len(bomb), 1 << 20)
        answer = bridge.place(bomb, "application/octet-stream", **{"Content-Encoding": "gzip"})
        self.assertEqual(answer.status, 413)
        empty = gzip.compress(b"") * 60000  # more than a MiB that inflates to nothing
        answer = bridge.place(empty, "application/octet-stream", **{"Content-Encoding": "gzip"})
        self.assertEqual(answer.status, 413)
        with open(f"/proc/{bridge.process.pid}/status", encoding="ascii") as status:
            peak = next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
        if not driver.sanitized():
            self.assertLess(peak, 64 << 10, "KiB at the most")

    def test_records_longer_than_a_message_come_in_fragments(self):
        record = json.dumps({"type": "result", "query": "q", "reason": 'a"\\\u00e9' * 100000},
                            ensure_ascii=False, separators=(",", ":"))
        script = program(self, "cat >/dev/null\ncat \"$0.txt\"\n")
        with open(script + ".txt", "w", encoding="utf-8") as file:
            file.write(record + "\n")
        bridge = self.bridge("--solve", script)
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        fragments = [m for m in bridge.messages(job) if m["type"] == "fragment"]
        self.assertGreater(len(fragments), 1)
        self.assertEqual([f["index"] for f in fragments], list(range(fragments[0]["count"])))
        self.assertEqual("".join(f["text"] for f in fragments), record)

    def test_a_record_that_its_program_did_not_finish_is_not_told(self):
        script = program(self, "cat >/dev/null\necho '{\"type\":\"metrics\"}'\n"
                               "printf '{\"type\":\"trajectory\",\"query'\nkill -KILL $$\n")
        bridge = self.bridge("--solve", script)
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        messages = bridge.messages(job)  # fails if an answer contains half a record
        self.assertEqual([m["record"] for m in messages if m["type"] == "record"],
                         [{"type": "metrics"}])
        self.assertEqual(messages[-1]["state"], "failed")

    def test_what_the_ring_has_lost_is_said(self):
        line = '{"type":"metrics","name":"' + "x" * 100000 + '"}'
        script = program(self, "cat >/dev/null\nfor i in $(seq 60); do cat \"$0.txt\"; done\n")
        with open(script + ".txt", "w", encoding="ascii") as file:
            file.write(line + "\n")
        bridge = self.bridge("--solve", script)
        begin = bridge.get("/v1/info").json()["cursor"]
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        self.assertTrue(eventually(lambda: bridge.get("/v1/info").json()["jobs"][0]["state"] == "done"))
        lost = bridge.get(f"/v1/jobs/{job}?cursor={begin}")
        self.assertEqual(lost.status, 410)
        self.assertIn("/v1/info", lost.json()["cure"])
        last = bridge.get("/v1/info").json()["cursor"]
        self.assertEqual(bridge.get(f"/v1/jobs/{job}?cursor={last - 5}").status, 200)

    def test_a_record_longer_than_what_is_kept_comes_whole_over_a_websocket(self):
        record = json.dumps({"type": "result", "query": "q", "reason": "x" * (9 << 20)},
                            separators=(",", ":"))
        script = program(self, "cat >/dev/null\ncat \"$0.txt\"\n")
        with open(script + ".txt", "w", encoding="ascii") as file:
            file.write(record + "\n")
        bridge = self.bridge("--solve", script)
        level = bridge.place_level(LEVEL)
        events = bridge.events()
        bridge.ask(level=level)
        messages = events.until(lambda m: m["type"] == "reload" or m.get("state") == "done")
        self.assertNotIn("reload", [m["type"] for m in messages])
        text = "".join(m["text"] for m in messages if m["type"] == "fragment")
        self.assertTrue(text == record, "lost or torn")  # not assertEqual: it would print both

    # --- time

    def test_a_bridge_that_ends_when_it_is_idle_stays_while_a_client_is_connected(self):
        bridge = self.bridge("--idle", "5", "--ping", "0.3")
        events = bridge.events()
        end = time.monotonic() + 8  # the bridge checks once a second whether it is idle
        while time.monotonic() < end:
            if events.receive() == {"type": "ping"}:
                events.send('{"type":"pong"}')
        self.assertIsNone(bridge.process.poll())
        events.close()
        self.assertEqual(bridge.process.wait(20), 0)

    def test_a_bridge_that_ends_when_it_is_idle_stays_while_a_level_is_read(self):
        # A folder of tools, one of which is slow.
        folder = driver.tempfile.mkdtemp(prefix="obby-bridge-")
        self.addCleanup(driver.shutil.rmtree, folder)
        for tool in ("obby-bridge", "obby-solve"):
            driver.shutil.copy(os.path.join(driver.BIN, tool), folder)
        slow = os.path.join(folder, "obby-import")
        with open(slow, "w", encoding="ascii") as file:
            file.write("#!/bin/sh\ncat >/dev/null\nsleep 6\n"
                       "echo '{\"type\":\"level\",\"name\":\"slow\"}'\n")
        os.chmod(slow, 0o755)
        bridge = self.bridge("--idle", "2", folder=folder)
        self.assertEqual(bridge.place(level_bytes(LEVEL)).status, 201)

    def test_slow_requests_are_given_up(self):
        bridge = self.bridge("--request-timeout", "1")
        half = self.head(bridge, "/v1/jobs", "Content-Type: application/json",
                         "Content-Length: 1000")
        slow = []
        for text in ("", "GET /v1/inf", half, half + "{"):  # four incomplete requests
            connection = bridge.socket()
            self.addCleanup(connection.close)
            connection.sendall(text.encode())
            slow.append(connection)
        self.assertEqual(bridge.get("/v1/info").status, 200)  # other clients do not wait for them
        for connection in slow:
            answer = connection.recv(65536)
            self.assertTrue(answer == b"" or answer.split(b" ", 2)[1] == b"408", answer)

    def test_many_idle_connections_are_bounded(self):
        bridge = self.bridge("--request-timeout", "1")
        idle = [bridge.socket() for _ in range(200)]
        for connection in idle:
            self.addCleanup(connection.close)
        self.assertTrue(eventually(lambda: self.answers(bridge)))

    def answers(self, bridge):
        try:
            return bridge.get("/v1/info", timeout=1).status == 200
        except OSError:
            return False

    def test_clients_that_send_half_and_close_are_still_answered(self):
        bridge = self.bridge()
        with bridge.socket() as connection:
            connection.sendall(
                f"GET /v1/info HTTP/1.1\r\nHost: 127.0.0.1:{bridge.port}\r\n\r\n".encode())
            connection.shutdown(driver.socket.SHUT_WR)
            self.assertTrue(connection.recv(65536).startswith(b"HTTP/1.1 200"))

    def test_silent_clients_lose_their_socket_and_then_their_jobs(self):
        bridge = self.bridge("--ping", "0.3", "--silence", "1.5", "--grace", "2")
        self.endless(bridge)
        events = bridge.events()
        messages = events.until(lambda m: False, 20)
        self.assertEqual(messages[-1], ("close", 4408))
        self.assertGreaterEqual(sum(m == {"type": "ping"} for m in messages), 2)
        self.assertTrue(bridge.jobs_running(), "the time of grace is not over")
        self.assertTrue(eventually(lambda: not bridge.jobs_running()))

    def test_clients_that_answer_pings_keep_both(self):
        bridge = self.bridge("--ping", "0.5", "--silence", "1.5", "--grace", "0.5")
        job = self.endless(bridge)
        events = bridge.events()
        end = time.monotonic() + 3.5  # longer than silence, grace and a check
        while time.monotonic() < end:
            message = events.receive()
            self.assertNotIsInstance(message, tuple)
            if message.get("type") == "ping":
                events.send('{"type":"pong"}')
        self.assertTrue(bridge.jobs_running())
        bridge.delete(f"/v1/jobs/{job}")
        events.send(b"\x03\xe8", opcode=8)  # a close frame gets an answer
        self.assertEqual(events.until(lambda m: False, 10)[-1], ("close", 1000))

    def test_a_client_that_reads_nothing_is_dropped(self):
        line = '{"type":"metrics","name":"' + "x" * 100000 + '"}'
        script = program(self, "cat >/dev/null\nwhile cat \"$0.txt\"; do :; done\n")
        with open(script + ".txt", "w", encoding="ascii") as file:
            file.write(line + "\n")
        bridge = self.bridge("--solve", script, "--silence", "1", "--grace", "1")
        level = bridge.place_level(LEVEL)
        events = bridge.events()
        self.assertEqual(events.status, 101)
        bridge.ask(level=level)
        self.assertTrue(eventually(bridge.jobs_running))
        self.assertTrue(eventually(lambda: not bridge.jobs_running()))
        events.close()
        self.assertEqual(bridge.get("/v1/info").status, 200)

    # --- programs

    def test_a_killed_program_fails_its_job_only(self):
        bridge = self.bridge()
        job = self.endless(bridge)
        os.kill(bridge.jobs_running()[0][0], signal.SIGKILL)
        last = bridge.messages(job)[-1]
        self.assertEqual(last["state"], "failed")
        self.assertIn("signal 9", last["reason"])
        level = bridge.place_level(LEVEL)
        again = bridge.messages(bridge.ask(level=level, ask=["any"])["job"])
        self.assertEqual(again[-1]["state"], "done")

    def test_a_program_that_ignores_sigint_is_killed_with_its_group(self):
        script = program(self, "trap '' INT\nsleep 1000 &\nsleep 1000 &\nwait\nsleep 1000\n")
        bridge = self.bridge("--solve", script)
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        self.assertTrue(eventually(bridge.jobs_running))
        leader = bridge.jobs_running()[0][0]
        self.assertTrue(eventually(lambda: len(driver.children(leader)) == 2))
        group = driver.children(leader)
        bridge.delete(f"/v1/jobs/{job}")
        self.assertEqual(bridge.messages(job)[-1]["state"], "cancelled")
        for pid, _ in group:
            self.assertTrue(eventually(lambda p=pid: not os.path.exists(f"/proc/{p}")))

    def test_a_bridge_that_is_killed_takes_its_programs_along(self):
        bridge = self.bridge()
        self.endless(bridge)
        programs = [pid for pid, _ in bridge.jobs_running()]
        bridge.process.kill()
        bridge.process.wait()
        for pid in programs:
            self.assertTrue(eventually(lambda p=pid: not os.path.exists(f"/proc/{p}")))

    def test_a_bridge_that_is_told_to_end_interrupts_its_jobs(self):
        bridge = self.bridge()
        self.endless(bridge)
        programs = [pid for pid, _ in bridge.jobs_running()]
        bridge.process.send_signal(signal.SIGTERM)
        self.assertEqual(bridge.process.wait(20), 143)
        for pid in programs:
            self.assertFalse(os.path.exists(f"/proc/{pid}"))
        self.assertEqual(os.listdir(os.path.join(bridge.state, "answers")), [])

    def told_to_end(self, last_words):
        """Ends a bridge whose job then writes a lot. Returns the bridge and its events."""
        script = program(self, f"trap '{last_words} >&2; exit 130' INT\ncat >/dev/null\n"
                         "echo up >&2\nwhile :; do sleep 0.05; done\n")
        bridge = self.bridge("--solve", script)
        events = bridge.events()
        bridge.ask(level=bridge.place_level(LEVEL))
        events.until(lambda m: m.get("text") == "up")
        bridge.process.send_signal(signal.SIGTERM)
        return bridge, events

    def test_a_bridge_that_ends_still_tells_all_that_its_jobs_said(self):
        """No message is lost, however many are still in transit when the last program ends."""
        bridge, events = self.told_to_end(
            "i=0; while [ $i -lt 400 ]; do echo line $i; i=$((i+1)); done")
        messages = events.until(lambda m: m.get("state") == "cancelled")
        self.assertEqual([m["text"] for m in messages if m["type"] == "report"],
                         [f"line {i}" for i in range(400)])
        self.assertEqual(events.receive(), ("close", 1001))
        self.assertEqual(bridge.process.wait(20), 143)

    def test_a_bridge_that_ends_answers_those_that_wait(self):
        bridge = self.bridge("--solve", program(self, "cat >/dev/null\nexec sleep 1000\n"))
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        cursor = bridge.messages(job, until=lambda m: m.get("state") == "running")[-1]["number"]
        with bridge.socket() as waiting:
            waiting.sendall(f"GET /v1/jobs/{job}?wait=20&cursor={cursor} HTTP/1.1\r\n"
                            f"Host: 127.0.0.1:{bridge.port}\r\n"
                            f"Authorization: Bearer {bridge.token}\r\n\r\n".encode())
            bridge.get("/v1/info")  # this answer shows that the earlier request was read
            self.assertFalse(driver.select.select([waiting], [], [], 0.2)[0])
            bridge.process.send_signal(signal.SIGTERM)
            answer = http.client.HTTPResponse(waiting)
            answer.begin()
            self.assertEqual(json.loads(answer.read())["state"], "cancelled")
        self.assertEqual(bridge.process.wait(20), 143)

    def test_a_bridge_that_ends_waits_for_no_client_that_reads_nothing(self):
        bridge, _ = self.told_to_end("head -c 30000000 /dev/zero | tr \\0 x | fold -w 9999")
        self.assertEqual(bridge.process.wait(20), 143)

    def test_processor_time_and_memory_are_bounded(self):
        if driver.sanitized():
            self.skipTest("sanitizers take more address space than any bound")
        script = program(self, "cat >/dev/null\nulimit -v\nulimit -t\nulimit -v >&2\nulimit -t >&2\n")
        bridge = self.bridge("--solve", script, "--memory", "512", "--cpu-time", "77")
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        said = [m["text"] for m in bridge.messages(job) if m["type"] == "report"]
        self.assertEqual(said[0], str(512 << 10))
        # SIGINT comes within a second after 77 s (see below). The program then has 3 s to write.
        self.assertGreaterEqual(int(said[1]), 77 + 4 * os.cpu_count())
        self.assertLess(int(said[1]), 77 + 20 * os.cpu_count())

    def test_a_program_that_takes_too_long_is_ended_and_it_is_said(self):
        bridge = self.bridge("--solve", program(self, "while :; do :; done\n"), "--cpu-time", "1")
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        self.assertIn("--cpu-time", bridge.messages(job)[-1]["reason"])

    def test_a_program_that_takes_too_long_still_tells_what_it_has(self):
        words = 'echo "{\\"type\\":\\"metrics\\"}"; exit 130'
        script = program(self, f"trap '{words}' INT\ncat >/dev/null\nwhile :; do :; done\n")
        bridge = self.bridge("--solve", script, "--cpu-time", "1")
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        messages = bridge.messages(job)
        self.assertEqual([m["record"] for m in messages if m["type"] == "record"],
                         [{"type": "metrics"}])
        self.assertEqual(messages[-1]["state"], "cancelled")
        self.assertIn("--cpu-time", messages[-1]["reason"])

    def test_programs_inherit_no_descriptor_and_no_secret(self):
        script = program(self, "cat >/dev/null\nls -l /proc/self/fd >&2\nenv >&2\n")
        bridge = self.bridge("--solve", script)
        job = bridge.ask(level=bridge.place_level(LEVEL))["job"]
        said = [m["text"] for m in bridge.messages(job) if m["type"] == "report"]
        open_ones = [line.split()[-3:] for line in said if "->" in line]
        self.assertEqual([fd for fd, _, _ in open_ones], ["0", "1", "2", "3"])
        self.assertRegex(open_ones[3][2], "^/proc/[0-9]+/fd$")  # ls reads this folder
        self.assertFalse([line for line in said if "OBBY" in line or bridge.token in line])

    # --- disk

    def test_a_full_disk_is_said_and_survived(self):
        bridge = self.bridge(preexec_fn=small_files)
        refused = bridge.place(level_bytes("demo.rbxlx"), "application/octet-stream")
        self.assertEqual(refused.status, 507, refused.body)
        self.assertIn("free disk space", refused.json()["cure"])
        self.assertEqual(os.listdir(os.path.join(bridge.state, "levels")), [])
        # A small level fits on the disk. Its answer does not fit, so it is sent but not kept.
        level = bridge.place_level(LEVEL)
        job = bridge.ask(level=level, ask=["any", "left"])["job"]
        messages = bridge.messages(job)
        self.assertEqual(messages[-1]["state"], "done")
        self.assertTrue([m for m in messages if "warm start" in str(m.get("report"))])
        self.assertEqual(bridge.post("/v1/jobs", {"level": level, "warm": job}).status, 409)
        self.assertEqual(os.listdir(os.path.join(bridge.state, "answers")), [])


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))


if __name__ == "__main__":
    driver.main(groups=3)
