// The service over standard input and output: one request a line in, one reply or message a line
// out.
#pragma once

#include <kj/async-io.h>
#include <kj/async-unix.h>

#include <memory>
#include <string>

#include "bridge/service.h"
#include "io/sink.h"

namespace obby::bridge {

class StdioFront {
 public:
  // The caller must use neither argument afterwards.
  StdioFront(Service& service, io::Sink output);
  ~StdioFront();

  // Runs until the input and all its jobs have ended, or the output can no longer be written.
  kj::Promise<void> run();
  // Writes the remaining messages and closes the output. Returns its error, even an earlier one.
  Status finish();

 private:
  kj::Promise<size_t> readSome();
  kj::Promise<void> requests();
  std::string takeLine(size_t end);
  void boundLine();
  kj::Promise<void> answer(std::string line);
  kj::Promise<void> events();
  void writeEvents();
  kj::Promise<void> readerGone();
  void write(std::string line);

  Service& service_;
  io::Sink output_;
  Status outputStatus_;
  std::shared_ptr<Client> client_;
  uint64_t cursor_ = 0;
  int flags_;                                      // flags of standard input that are restored
  kj::Own<kj::AsyncInputStream> input_;            // null for a file, which is always ready
  kj::Own<kj::UnixEventPort::FdObserver> reader_;  // watches the output; null for a file
  std::string rest_;
  size_t searched_ = 0;   // bytes of `rest_` that have no newline
  bool tooLong_ = false;  // the line being read is skipped
  bool inputEnded_ = false;
  char buffer_[65536];
};

}  // namespace obby::bridge
