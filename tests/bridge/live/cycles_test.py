"""A thousand clients connect, ask, cancel and leave. Nothing may be left, and no step may be slow.

The bound on the time is wide, since tests run on busy machines. The test prints the times."""
import os
import sys
import time
import unittest

import driver
from driver import Bridge, eventually, impossible

CYCLES = int(os.environ.get("OBBY_TEST_CYCLES", "1000"))
BOUND = 1.0  # seconds, for 99 of 100 steps


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


class CyclesTest(unittest.TestCase):
    def test_cycles_leave_nothing_behind(self):
        bridge = Bridge("--jobs", "2")
        self.addCleanup(bridge.close)
        level = bridge.place_level("several-routes.jsonl")
        before = open_files(bridge)
        connect, ask, cancel, whole = [], [], [], []
        self.started = 0
        for i in range(CYCLES):
            begin = time.monotonic()
            events = self.connect(bridge)
            connected = time.monotonic()
            job = self.ask(bridge, level)
            asked = time.monotonic()
            self.assertEqual(bridge.delete(f"/v1/jobs/{job}").status, 202)
            cancelled = time.monotonic()
            if i % 2:  # half of the clients send a close frame
                events.send(b"\x03\xe8", opcode=8)
            events.close()
            connect.append(connected - begin)
            ask.append(asked - connected)
            cancel.append(cancelled - asked)
            whole.append(cancelled - begin)
        self.assertTrue(eventually(lambda: not bridge.jobs_running()), bridge.jobs_running())
        self.assertTrue(eventually(lambda: open_files(bridge) <= before), "descriptors are left")
        self.assertEqual(bridge.get("/v1/info").status, 200)
        sys.stderr.write(f"\n  {self.started} of {CYCLES} jobs began to run at once")
        self.assertGreater(self.started, CYCLES // 10)
        for name, values in (("connect", connect), ("ask", ask), ("cancel", cancel),
                             ("cycle", whole)):
            sys.stderr.write(f"\n  {name}: median {1000 * percentile(values, 0.5):.2f} ms, "
                             f"p99 {1000 * percentile(values, 0.99):.2f} ms, "
                             f"most {1000 * max(values):.2f} ms")
            self.assertLess(percentile(values, 0.99), BOUND, name)
        sys.stderr.write("\n")

    def connect(self, bridge):
        """Opens a WebSocket. The bridge may not have noticed yet that the previous one is gone."""
        end = time.monotonic() + 10
        while time.monotonic() < end:
            events = bridge.events()
            if events.status == 101:
                events.receive()
                return events
            self.assertEqual(events.status, 409)
            events.close()
        raise AssertionError("the WebSocket before was never missed")

    def ask(self, bridge, level):
        """Orders a job. Earlier jobs may still be ending."""
        end = time.monotonic() + 10
        while time.monotonic() < end:
            answer = bridge.post("/v1/jobs", {"level": level, "queries": [impossible()],
                                              "budget": {"timeLimit": 60}})
            if answer.status == 202:
                self.started += answer.json()["state"] == "running"
                return answer.json()["job"]
            self.assertEqual(answer.status, 429)
        raise AssertionError("there never was room for a job")


def open_files(bridge):
    return len(os.listdir(f"/proc/{bridge.process.pid}/fd"))


if __name__ == "__main__":
    driver.main()
