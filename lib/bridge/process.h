// A program started for a client, by absolute path and argument array, never through a shell. It
// has its own process group and limited memory and processor time, and does not outlive the bridge.
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
  uint64_t memoryBytes = 0;            // RLIMIT_AS; 0 for the bridge's own
  uint64_t cpuSeconds = 0;             // RLIMIT_CPU; 0 for the bridge's own
};

struct Exit {
  int code = 0;    // exit code, valid if signal is 0
  int signal = 0;  // signal that ended the program; 0 if it ended by itself
};

class Process {
 public:
  // Starts a program. If it cannot be started, the error has the system's reason. The caller's
  // thread must live as long as the process, because the kernel ends it with that thread.
  static Result<Process> start(const Command& command);

  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;
  // Kills the program's group if it was not reaped, and waits, so that no process is left.
  ~Process();

  // The bridge's ends of the program's standard streams. Each has one owner.
  OwnedFd input, output, errors;
  // Becomes readable when the program has ended.
  int exitFd() const { return exitFd_.get(); }
  pid_t id() const { return pid_; }
  // Returns the processor time of the program, without its children; 0 once it has been reaped.
  double cpuSeconds() const;

  // Sends a signal to the program's whole group, if it has not been reaped.
  void signal(int number) const;
  // Kills the rest of the program's group and returns the program's exit. Call it only after the
  // program has ended.
  Exit reap();

 private:
  Process() = default;
  pid_t pid_ = 0;
  OwnedFd exitFd_;
};

}  // namespace obby::bridge
