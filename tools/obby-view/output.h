// A report goes where -o says, in the format that was asked for.
#pragma once

#include <utility>

#include "cli/context.h"
#include "io/sink.h"
#include "view/report.h"

namespace obby {

class Output {
 public:
  // Before anything is read, so that what cannot be written is said at once: a file that cannot be,
  // a picture for a terminal, a --size that is none.
  static Result<Output> open(const cli::Context& context);

  // Call it once, if at all: without it no file is left.
  Status write(const view::Report& report, cli::Context& context);

 private:
  explicit Output(io::Sink sink) : sink_(std::move(sink)) {}

  io::Sink sink_;
};

}  // namespace obby
