// The event loop of a server: one thread, which ends when a flag is set.
#pragma once

#include <kj/async-io.h>
#include <kj/exception.h>

#include <atomic>
#include <functional>
#include <string>

namespace obby::loopback {

// Says something to those who want to know everything; a line without its newline.
using Note = std::function<void(const std::string&)>;

// On the stack, one a thread.
class EventLoop {
  // What the loop's library would print, said as a note, as long as there is anything of the loop.
  class Quiet final : public kj::ExceptionCallback {
   public:
    explicit Quiet(Note note) : note_(std::move(note)) {}
    void logMessage(kj::LogSeverity, const char*, int, int, kj::String&& text) override {
      note_(text.cStr());
    }

   private:
    Note note_;
  };
  Quiet quiet_;

 public:
  explicit EventLoop(Note note) : quiet_(std::move(note)), io(kj::setupAsyncIo()) {}

  kj::AsyncIoContext io;

  // When `stop` is set: looked at some 20 times a second, for a signal cannot wake the loop.
  kj::Promise<void> untilSet(const std::atomic<bool>& stop);
};

}  // namespace obby::loopback
