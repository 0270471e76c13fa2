// Limits of the bridge for its clients. This file has all of them. Their sources are docs/bridge.md
// and, for a Studio plugin, the engine's own limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace obby::bridge {

inline constexpr uint32_t kProtocol = 1;  // raised when older clients would break

inline constexpr uint64_t kMiB = uint64_t(1) << 20;

struct Limits {
  // requests
  uint64_t bodyBytes = 64 * kMiB;       // max size of a request as sent
  uint64_t inflatedBytes = 256 * kMiB;  // max size of a gzip body, inflated
  uint64_t pairBytes = 4 << 10;         // max size of a request to pair, which needs no token
  double requestSeconds = 60;           // max time for a request's head, and then for its body
  double maxWaitSeconds = 20;           // max wait of a long poll
  uint32_t connections = 64;            // max open at a time
  uint32_t clients = 16;                // max paired at a time; the oldest token is dropped first

  // messages
  uint64_t messageBytes = 256 << 10;  // longer records are sent in fragments
  uint64_t ringBytes = 4 * kMiB;      // messages kept for each client, to resume from a cursor
  uint64_t unsentBytes = 64 * kMiB;   // messages kept until the client's WebSocket takes them
  double pingSeconds = 20;            // time between pings on a WebSocket
  double silenceSeconds = 60;  // time without a message after which a client loses its WebSocket
  double graceSeconds = 30;    // time after that until its jobs are cancelled

  // jobs
  uint32_t jobs = 2;          // max programs of jobs that run at a time
  uint32_t waiting = 16;      // jobs of a client that wait for their turn
  uint32_t keptJobs = 64;     // ended jobs of a client that are kept for its requests
  uint32_t queries = 1000;    // max queries of a job
  double stopSeconds = 3;     // time from SIGINT to SIGKILL
  double importSeconds = 60;  // max time to read a level
#if defined(OBBY_BRIDGE_SANITIZED)
  uint64_t memoryBytes = 0;  // sanitizers reserve more than any bound
#else
  uint64_t memoryBytes = 8192 * kMiB;  // address space of a program; 0 for no limit
#endif
  uint64_t cpuSeconds = 3600;  // processor time after which a program is interrupted
  // Returns the processor time after which the system ends a program and its results are lost. The
  // threads may use all `processors` until the bridge notices the limit above, and while the
  // program writes its results.
  uint64_t maxCpuSeconds(uint32_t processors) const {
    constexpr uint64_t kSeenAfter = 4;  // seconds; the bridge may be busy
    const uint64_t late = processors * (kSeenAfter + uint64_t(std::ceil(stopSeconds)));
    return cpuSeconds + std::max({uint64_t(10), cpuSeconds / 10, late});
  }

  // the private folder
  uint64_t storeBytes = 512 * kMiB;  // max size of kept levels; the least recently used go first
  uint64_t answerBytes = 64 * kMiB;  // max size of an answer kept for a warm start
};

}  // namespace obby::bridge
