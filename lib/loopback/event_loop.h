// The event loop of a server. It runs on one thread and ends when a flag is set.
#pragma once

#include <kj/async-io.h>
#include <kj/exception.h>

#include <atomic>
#include <functional>
#include <string>

namespace obby::loopback {

// Receives a line for verbose output, without its newline.
using Note = std::function<void(const std::string&)>;

// The event loop of the calling thread. Create it on the stack, at most one per thread.
class EventLoop {
  // Turns messages that the loop's library would print into notes, while any part of the loop
  // exists.
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

  // Resolves when `stop` is set. Polls some 20 times a second, because a signal cannot wake the
  // loop.
  kj::Promise<void> untilSet(const std::atomic<bool>& stop);
};

}  // namespace obby::loopback
