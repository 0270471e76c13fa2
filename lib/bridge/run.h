// Runs a started program on the event loop: feeds its input, passes on its output line by line, and
// waits for its end.
#pragma once

#include <kj/async-io.h>
#include <kj/async-unix.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "bridge/process.h"

namespace obby::bridge {

// The event loop that all parts of the bridge share.
struct Loop {
  kj::LowLevelAsyncIoProvider& io;
  kj::UnixEventPort& events;
  kj::Timer& timer;
  double now() const;  // seconds, steady
};

class Run {
 public:
  using OnLine = std::function<void(std::string_view line)>;  // without its newline

  // Max bytes of a line. A longer one ends the program. A record of 256 MiB in memory is a shorter
  // line than this.
  static constexpr size_t kMaxLine = size_t(512) << 20;

  // `onOutput` receives whole lines only; `onError` also receives a last line without a newline.
  Run(Loop& loop, Process process, std::string input, OnLine onOutput, OnLine onError);

  // Resolves once the program has ended and all its output has been passed on. Call it once.
  // Dropping the promise, or this object, kills the program. An exception of a handler also ends
  // the program, and is the promise's error.
  kj::Promise<Exit> done();
  // Signals the whole group. SIGINT lets our tools complete their results.
  void signal(int number) { process_.signal(number); }
  pid_t id() const { return process_.id(); }
  double cpuSeconds() const { return process_.cpuSeconds(); }

 private:
  kj::Promise<void> feed();
  kj::Promise<void> endingIt(kj::Promise<void> reading);
  kj::Promise<void> lines(kj::AsyncInputStream& from, std::string& rest, const OnLine& onLine);

  Process process_;
  std::string text_, outRest_, errRest_;
  OnLine onOutput_, onError_;
  kj::Own<kj::AsyncOutputStream> input_;
  kj::Own<kj::AsyncInputStream> output_, errors_;
  kj::UnixEventPort::FdObserver exited_;
  char outBuffer_[65536], errBuffer_[4096];
};

}  // namespace obby::bridge
