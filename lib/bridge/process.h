// A program started for a client: by absolute path and argument array, never through a shell, in a
// process group of its own, with bounded memory and processor time; it does not outlive the bridge.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "loopback/owned_fd.h"

namespace obby::bridge {

using loopback::OwnedFd;

struct Command {
  std::string path;                    // absolute
  std::vector<std::string> arguments;  // without the program's name
  uint64_t memoryBytes = 0;            // RLIMIT_AS; 0: as the bridge
  uint64_t cpuSeconds = 0;             // RLIMIT_CPU; 0: as the bridge
};

struct Exit {
  int code = 0;    // if signal is 0
  int signal = 0;  // that ended it; 0: it ended by itself
};

class Process {
 public:
  // Error: it cannot be started, with the system's reason. The caller's thread must live as long
  // as the process: the kernel ends it with that thread.
  static Result<Process> start(const Command& command);

  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  // Kills what still runs, and waits for it: nothing stays behind.
  ~Process();

  // The near ends of its standard streams, each to be taken by one owner; reading and writing do
  // not block.
  OwnedFd input, output, errors;
  // Becomes readable when the program has ended.
  int exitFd() const { return exitFd_.get(); }
  pid_t id() const { return pid_; }
  // Processor time that it has used, its children not; 0 once it has been reaped.
  double cpuSeconds() const;

  // To its whole group, if it has not been reaped.
  void signal(int number) const;
  // Only once it has ended: kills what is left of its group, and takes its exit.
  Exit reap();

 private:
  Process() = default;
  pid_t pid_ = 0;
  OwnedFd exitFd_;
};

}  // namespace obby::bridge
