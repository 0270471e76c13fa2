// A started program on the event loop: its input fed, its output handed on line by line, its end
// awaited.
#pragma once

#include <kj/async-io.h>
#include <kj/async-unix.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "bridge/process.h"

namespace obby::bridge {

// What the parts of the bridge share of the event loop.
struct Loop {
  kj::LowLevelAsyncIoProvider& io;
  kj::UnixEventPort& events;
  kj::Timer& timer;
  double now() const;  // seconds, steady
};

class Run {
 public:
  using OnLine = std::function<void(std::string_view line)>;  // without its newline

  // Longer lines end the program. A record of 256 MiB in memory is shorter than that as JSON.
  static constexpr size_t kMaxLine = size_t(512) << 20;

  // `onOutput` gets whole lines only, `onError` also a last one that has no newline.
  Run(Loop& loop, Process process, std::string input, OnLine onOutput, OnLine onError);

  // When the program has ended and all that it wrote has been handed on. Call once; dropping the
  // promise, or this, kills the program. Fails with what a handler throws, which ends the program.
  kj::Promise<Exit> done();
  // To the whole group: SIGINT lets our tools finish what they have.
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
