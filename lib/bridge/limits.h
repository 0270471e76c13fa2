// What the bridge grants its clients. Every number that bounds something stands here; the sources
// are docs/bridge.md and, where a client is a Studio plugin, the engine's own limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace obby::bridge {

inline constexpr uint32_t kProtocol = 1;  // raised when older clients would go wrong

inline constexpr uint64_t kMiB = uint64_t(1) << 20;

struct Limits {
  // requests
  uint64_t bodyBytes = 64 * kMiB;       // of a request as it is sent
  uint64_t inflatedBytes = 256 * kMiB;  // of a gzip body, inflated
  uint64_t pairBytes = 4 << 10;         // of a request to pair, which needs no token
  double requestSeconds = 60;           // until a request's head, and then its body, has come
  double maxWaitSeconds = 20;           // a long poll
  uint32_t connections = 64;            // open at a time
  uint32_t clients = 16;                // paired at a time; the oldest token goes first

  // messages
  uint64_t messageBytes = 256 << 10;  // of one message; longer records go out in fragments
  uint64_t ringBytes = 4 * kMiB;      // kept for each client, to resume from a cursor
  uint64_t unsentBytes = 64 * kMiB;   // kept of what its WebSocket has yet to take
  double pingSeconds = 20;            // between pings on a WebSocket
  double silenceSeconds = 60;         // without a word from the client: its WebSocket is closed
  double graceSeconds = 30;           // after that: its jobs are cancelled

  // jobs
  uint32_t jobs = 2;          // programs of jobs that run at a time
  uint32_t waiting = 16;      // jobs of a client that wait for their turn
  uint32_t keptJobs = 64;     // ended jobs of a client that can still be asked about
  uint32_t queries = 1000;    // of a job
  double stopSeconds = 3;     // from SIGINT to SIGKILL
  double importSeconds = 60;  // for reading a level
#if defined(OBBY_BRIDGE_SANITIZED)
  uint64_t memoryBytes = 0;  // sanitizers reserve more than any bound
#else
  uint64_t memoryBytes = 8192 * kMiB;  // address space of a program; 0: not bounded
#endif
  uint64_t cpuSeconds = 3600;  // processor time of a program: then it is interrupted
  // Then the system ends it, and what it has is lost. `processors`, all of which its threads may
  // use up while the bridge gets to see that, and while the program writes what it has.
  uint64_t mostCpuSeconds(uint32_t processors) const {
    constexpr uint64_t kSeenAfter = 4;  // seconds: asked each second, by a bridge that may be busy
    const uint64_t late = processors * (kSeenAfter + uint64_t(std::ceil(stopSeconds)));
    return cpuSeconds + std::max({uint64_t(10), cpuSeconds / 10, late});
  }

  // the private folder
  uint64_t storeBytes = 512 * kMiB;  // levels kept; the longest unused go first
  uint64_t answerBytes = 64 * kMiB;  // of an answer kept for a warm start
};

}  // namespace obby::bridge
