"""The requests of a plugin if nothing goes wrong: place, ask, stream, cancel, resume."""
import gzip
import json
import os
import subprocess
import unittest

import driver
from driver import Bridge, impossible, level_bytes

LEVEL = "several-routes.jsonl"


def ended(message):
    return message.get("type") == "state" and message["state"] in ("done", "cancelled", "failed")


class ProtocolTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bridge = Bridge("--jobs", "2")

    @classmethod
    def tearDownClass(cls):
        cls.bridge.close()

    def verdicts(self, messages):
        return {m["record"]["query"]: m["record"]["verdict"] for m in messages
                if m.get("type") == "record" and m["record"]["type"] == "result"}

    def test_info_says_little_to_strangers(self):
        stranger = self.bridge.get("/v1/info", token=None)
        self.assertEqual(stranger.status, 200)
        self.assertEqual(sorted(stranger.json()),
                         ["name", "needsToken", "pairing", "protocol", "version"])
        own = self.bridge.get("/v1/info").json()
        self.assertTrue({"session", "cursor", "limits", "tools"} <= set(own))
        self.assertNotIn("Access-Control-Allow-Origin", stranger.headers)

    def test_records_are_placed_once_and_given_back(self):
        data = level_bytes(LEVEL)
        first = self.bridge.place(data)
        again = self.bridge.place(data)
        self.assertIn(first.status, (200, 201))
        self.assertEqual(again.status, 200)
        self.assertEqual(first.json()["level"], again.json()["level"])
        self.assertIn("no-jumps", again.json()["queries"])
        back = self.bridge.get("/v1/levels/" + first.json()["level"])
        types = [json.loads(line)["type"] for line in back.body.splitlines()]
        self.assertEqual(types[0], "level")
        self.assertEqual(types.count("query"), len(again.json()["queries"]))

    def test_of_a_level_only_what_moves_can_be_asked_for(self):
        level = self.bridge.place_level("vanishing-run.jsonl")
        whole = json.loads(self.bridge.get(f"/v1/levels/{level}").body.splitlines()[0])
        some = self.bridge.get(f"/v1/levels/{level}?parts=moving").body.splitlines()
        self.assertEqual(len(some), 1)
        vanishing = [p if "vanish" in p else {} for p in whole["parts"]]
        self.assertEqual(json.loads(some[0]), {**whole, "parts": vanishing})
        self.assertIn({}, vanishing)
        self.assertEqual(self.bridge.get(f"/v1/levels/{level}?parts=all").status, 400)

    def test_records_may_be_written_by_hand(self):
        level = json.loads(level_bytes(LEVEL).splitlines()[0])
        del level["type"]
        by_hand = json.dumps({**level, "type": "level"}, indent=None, separators=(" , ", " : "))
        answer = self.bridge.place(by_hand.encode() + b'\n { "id" : "q" , "type" : "query" }\n')
        self.assertEqual(answer.status, 201, answer.body)
        self.assertEqual(answer.json()["queries"], ["q"])
        back = self.bridge.get("/v1/levels/" + answer.json()["level"]).body
        self.assertTrue(back.startswith(b'{"type":"level"'))

    def test_a_place_file_is_imported(self):
        answer = self.bridge.place(level_bytes("demo.rbxlx"), "application/octet-stream")
        self.assertEqual(answer.status, 201, answer.body)
        self.assertEqual(answer.json()["queries"], ["stage1", "stage2", "stage3", "stage4"])

    def test_warnings_come_each_time_that_a_level_is_placed(self):
        place = (b'<roblox version="4"><Item class="Part" referent="A"><Properties>'
                 b'<string name="Name">Floor</string></Properties></Item></roblox>')
        first = self.bridge.place(place, "application/octet-stream")
        again = self.bridge.place(place, "application/octet-stream")
        self.assertEqual((first.status, again.status), (201, 200))
        self.assertIn("no start found", first.json()["warnings"][0]["message"])
        self.assertEqual(again.json(), first.json())
        back = self.bridge.get("/v1/levels/" + first.json()["level"])
        self.assertEqual([json.loads(line)["type"] for line in back.body.splitlines()], ["level"])

    def test_gzip_is_inflated(self):
        plain = self.bridge.place(level_bytes(LEVEL)).json()["level"]
        packed = self.bridge.place(gzip.compress(level_bytes(LEVEL)), **{"Content-Encoding": "gzip"})
        self.assertEqual(packed.status, 200, packed.body)
        self.assertEqual(packed.json()["level"], plain)
        cut = self.bridge.place(gzip.compress(level_bytes(LEVEL))[:-20],
                                **{"Content-Encoding": "gzip"})
        self.assertEqual(cut.status, 400)

    def test_damaged_levels_are_explained(self):
        bad = self.bridge.place(b'{"type":"level","parts":[{"size":[1,2]}]}\n')
        self.assertEqual(bad.status, 422)
        self.assertEqual(bad.json()["path"], "parts[0].size")
        nothing = self.bridge.place(b'{"type":"query","id":"q"}\n')
        self.assertEqual(nothing.status, 422)
        self.assertIn("no level", nothing.json()["error"])

    def test_own_queries_are_answered_by_long_polls(self):
        level = self.bridge.place_level(LEVEL)
        job = self.bridge.ask(level=level, ask=["any", "no-jumps"], budget={"seed": "7"})
        messages = self.bridge.messages(job["job"])
        self.assertEqual(self.verdicts(messages)["any"], "solved")
        self.assertEqual(set(self.verdicts(messages)), {"any", "no-jumps"})
        self.assertEqual([m["state"] for m in messages if m["type"] == "state"],
                         ["waiting", "running", "done"])
        records = [m["record"] for m in messages if "record" in m]
        self.assertEqual(records[-1]["type"], "end")
        numbers = [m["number"] for m in messages]
        self.assertEqual(numbers, sorted(set(numbers)))

    def test_a_new_query_streams_over_a_websocket(self):
        level = self.bridge.place_level(LEVEL)
        events = self.bridge.events()
        self.assertEqual(events.status, 101)
        hello = events.receive()
        self.assertEqual(hello["type"], "hello")
        query = {"id": "mine", "goal": {"position": [0, 3, -68], "size": [20, 6, 10]},
                 "avoid": [], "start": []}
        job = self.bridge.ask(level=level, queries=[query], budget={"attempts": 2})
        messages = events.until(ended)
        self.assertEqual({m["job"] for m in messages if "job" in m}, {job["job"]})
        self.assertEqual(self.verdicts(messages), {"mine": "solved"})
        events.close()
        # A client resumes from a cursor after a lost connection.
        middle = messages[len(messages) // 2]["number"]
        self.assertTrue(driver.eventually(lambda: self.resumed(hello, middle, messages)))

    def resumed(self, hello, cursor, messages):
        events = self.bridge.events(f"?session={hello['session']}&cursor={cursor}")
        try:
            if events.status == 409:  # the bridge has not noticed the last close yet
                return False
            events.receive()
            after = events.until(lambda m: m.get("number") == messages[-1]["number"])
            return after == [m for m in messages if m["number"] > cursor]
        finally:
            events.close()

    def test_cursors_of_other_times_are_refused(self):
        session = self.bridge.get("/v1/info").json()["session"]
        for query in (f"?session={session}&cursor=999999", "?session=0123456789abcdef&cursor=0"):
            events = self.bridge.events(query)
            self.assertEqual(events.status, 410)
            events.close()

    def test_jobs_of_an_earlier_bridge_are_told_from_unknown_ones(self):
        session = self.bridge.get("/v1/info").json()["session"]
        earlier = self.bridge.get("/v1/jobs/j999?session=0123456789abcdef")
        self.assertEqual(earlier.status, 410)
        self.assertIn("restarted", earlier.json()["error"])
        self.assertEqual(self.bridge.get(f"/v1/jobs/j999?session={session}").status, 404)

    def test_cancelled_jobs_end_properly(self):
        level = self.bridge.place_level(LEVEL)
        job = self.bridge.ask(level=level, queries=[impossible()], budget={"timeLimit": 60})["job"]
        self.bridge.messages(job, until=lambda m: m["type"] in ("progress", "record"))
        self.assertEqual(self.bridge.delete(f"/v1/jobs/{job}").status, 202)
        messages = self.bridge.messages(job)
        self.assertEqual(messages[-1]["state"], "cancelled")
        ends = [m["record"] for m in messages
                if m["type"] == "record" and m["record"]["type"] == "end"]
        self.assertEqual([e["status"] for e in ends], ["interrupted"])

    def test_a_newer_long_poll_ends_the_older(self):
        level = self.bridge.place_level(LEVEL)
        job = self.bridge.ask(level=level, queries=[impossible()], budget={"timeLimit": 60})["job"]
        last = self.bridge.get("/v1/info").json()["cursor"] + 10**6
        self.assertEqual(self.bridge.get(f"/v1/jobs/{job}?cursor={last}&wait=1").status, 410)
        quiet = self.bridge.ask(level=level, queries=[impossible()], budget={"timeLimit": 60})
        # This job is queued, so it sends nothing.
        third = self.bridge.ask(level=level, queries=[impossible()])["job"]
        cursor = self.bridge.get(f"/v1/jobs/{third}").json()["cursor"]
        poll = f"/v1/jobs/{third}?cursor={cursor}"
        older = self.bridge.socket()
        older.sendall((f"GET {poll}&wait=20 HTTP/1.1\r\nHost: 127.0.0.1:{self.bridge.port}\r\n"
                       f"Authorization: Bearer {self.bridge.token}\r\n\r\n").encode())
        driver.time.sleep(0.2)  # so that the bridge reads the connections in this order
        begin = driver.time.monotonic()
        self.bridge.get(f"{poll}&wait=1")
        self.assertTrue(older.recv(65536).startswith(b"HTTP/1.1 200 "))
        older.close()
        self.assertLess(driver.time.monotonic() - begin, 10)
        for one in (third, job, quiet["job"]):
            self.bridge.delete(f"/v1/jobs/{one}")
        for one in (third, job, quiet["job"]):
            self.bridge.messages(one)

    def test_long_polls_of_several_jobs_leave_each_other_alone(self):
        bridge = Bridge("--solve", driver.program(self, "cat >/dev/null\nexec sleep 1000\n"))
        self.addCleanup(bridge.close)
        level, polls = bridge.place_level(LEVEL), []
        for _ in range(2):  # several windows of one Studio do this
            job = bridge.ask(level=level)["job"]
            heard = bridge.messages(job, until=lambda m: m.get("state") == "running")
            connection = bridge.socket()
            self.addCleanup(connection.close)
            connection.sendall((f"GET /v1/jobs/{job}?cursor={heard[-1]['number']}&wait=20 HTTP/1.1"
                                f"\r\nHost: 127.0.0.1:{bridge.port}\r\n"
                                f"Authorization: Bearer {bridge.token}\r\n\r\n").encode())
            polls.append(connection)
            self.assertFalse(driver.select.select(polls, [], [], 0.2)[0])

    def test_warm_starts_use_an_earlier_answer(self):
        level = self.bridge.place_level(LEVEL)
        first = self.bridge.ask(level=level, ask=["any"])["job"]
        self.bridge.messages(first)
        second = self.bridge.ask(level=level, ask=["any"], warm=first)["job"]
        self.assertEqual(self.verdicts(self.bridge.messages(second)), {"any": "solved"})
        refused = self.bridge.post("/v1/jobs", {"level": level, "warm": "j999"})
        self.assertEqual(refused.status, 409)
        session = self.bridge.get("/v1/info").json()["session"]
        os.remove(os.path.join(self.bridge.state, "answers", f"{session}-{first}.jsonl"))
        gone = self.bridge.post("/v1/jobs", {"level": level, "warm": first})
        self.assertEqual(gone.status, 409)
        self.assertIn("leave out 'warm'", gone.json()["cure"])

    def test_a_query_that_cannot_be_asked_stops_no_other(self):
        level = self.bridge.place_level(LEVEL)
        good = {"id": "good", "goal": {"position": [0, 2, 0], "size": [8, 8, 8]}}
        lost = [{"id": name, "goal": {"part": "No " + name}} for name in ("first", "second")]
        job = self.bridge.ask(level=level, queries=[lost[0], good, lost[1]])
        messages = self.bridge.messages(job["job"])
        self.assertEqual(self.verdicts(messages), {"good": "solved"})
        self.assertEqual(messages[-1]["state"], "failed")
        self.assertIn("No first", messages[-1]["reason"])
        errors = [m["report"] for m in messages if m["type"] == "report"
                  and m["report"]["type"] == "error"]
        self.assertEqual([e["place"] for e in errors], ["2", "4"])

    def test_bad_orders_are_explained(self):
        level = self.bridge.place_level(LEVEL)
        for order, status, path in [
                ({"level": "0" * 32}, 404, None),
                ({"level": "../../etc/passwd"}, 400, "level"),
                ({"level": level, "ask": ["nay"]}, 404, None),
                ({"level": level, "budget": {"timeLimit": "5"}}, 400, "budget.timeLimit"),
                ({"level": level, "budget": {"policy": "/etc/passwd"}}, 400, 'budget."policy"'),
                ({"level": level, "budget": {"solutions": 1.5}}, 400, "budget.solutions"),
                ({"level": level, "queries": [{"goal": {"size": [1]}}]}, 400,
                 "queries[0].goal.size"),
                ({"level": level, "queries": [{"type": "level"}]}, 400, "queries[0].type"),
                ({"level": level, "arguments": ["-o", "x"]}, 400, '"arguments"'),
                ({"level": level, "warm": "../j1"}, 400, "warm")]:
            answer = self.bridge.post("/v1/jobs", order)
            self.assertEqual(answer.status, status, (order, answer.body))
            self.assertTrue(answer.json()["error"])
            self.assertEqual(answer.json().get("path"), path)

    def test_calibration_without_its_tool_is_refused_by_name(self):
        # Holds all tools except obby-calibrate.
        folder = driver.tempfile.mkdtemp(prefix="obby-bridge-")
        self.addCleanup(driver.shutil.rmtree, folder)
        for tool in ("obby-bridge", "obby-solve", "obby-import"):
            driver.shutil.copy(os.path.join(driver.BIN, tool), folder)
        bridge = Bridge(folder=folder)
        self.addCleanup(bridge.close)
        answer = bridge.post("/v1/jobs", {"task": "calibrate", "level": "0" * 32,
                                          "recordings": [{}]})
        self.assertEqual(answer.status, 501)
        self.assertIn("obby-calibrate", answer.json()["error"])

    def test_recordings_are_calibrated(self):
        tool = os.path.join(driver.BIN, "obby-calibrate")
        if not os.path.exists(tool):
            self.skipTest("no obby-calibrate here")
        rehearsed = subprocess.run([tool, "--rehearse"], input=b"", capture_output=True, check=True)
        records = [json.loads(line) for line in rehearsed.stdout.splitlines()]
        level = self.bridge.place(b"\n".join(json.dumps(r).encode() for r in records
                                             if r["type"] == "level") + b"\n").json()["level"]
        # All manoeuvres would take too long.
        few = ("jump on the spot", "jump and turn back in the air")
        recordings = [r for r in records if r["type"] == "recording" and r["name"] in few]
        self.assertEqual(len(recordings), 2)
        job = self.bridge.ask(task="calibrate", level=level, recordings=recordings,
                              budget={"restarts": 1, "generations": 1, "seed": 3})["job"]
        messages = self.bridge.messages(job)
        self.assertEqual(messages[-1]["state"], "done", messages[-1])
        types = {m["record"]["type"] for m in messages if m["type"] == "record"}
        self.assertTrue({"params", "end"} <= types, types)
        notes = [m["report"]["message"] for m in messages
                 if m["type"] == "report" and m["report"].get("type") == "note"]
        self.assertTrue(any("gravity" in note and "studs off" in note for note in notes), notes)

    def test_a_second_client_sees_nothing_of_the_first(self):
        level = self.bridge.place_level(LEVEL)
        job = self.bridge.ask(level=level, ask=["any"])["job"]
        self.bridge.messages(job)
        path = os.path.join(self.bridge.state, "tokens")
        self.assertEqual(os.stat(path).st_mode & 0o777, 0o600)
        other = Bridge(state=self.bridge.state)  # uses the same folder
        try:
            self.assertNotEqual(other.token, self.bridge.token)
            self.assertEqual(other.get("/v1/info", token=self.bridge.token).status, 200)
            self.assertEqual(other.get(f"/v1/jobs/{job}").status, 404)
        finally:
            other.close()


if __name__ == "__main__":
    driver.main()
