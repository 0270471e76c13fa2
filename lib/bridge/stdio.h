// The service over standard input and output: a request a line in, answers and messages a line out.
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
  // Neither may be used by anybody else from here on.
  StdioFront(Service& service, io::Sink output);
  ~StdioFront();

  // Until the input has ended and every job with it, or the output can no longer be written.
  kj::Promise<void> run();
  // Writes what is left, and closes. Error: of the output, also an earlier one.
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
  int flags_;                                      // of standard input, to be put back
  kj::Own<kj::AsyncInputStream> input_;            // null: a file, which is always ready
  kj::Own<kj::UnixEventPort::FdObserver> reader_;  // of the output; null: a file has none
  std::string rest_;
  size_t searched_ = 0;   // of `rest_`: no newline is in that
  bool tooLong_ = false;  // the line that is coming: passed over
  bool inputEnded_ = false;
  char buffer_[65536];
};

}  // namespace obby::bridge
