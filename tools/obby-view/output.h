// Writes a report to the -o file in the requested format.
#pragma once

#include <utility>

#include "cli/context.h"
#include "io/sink.h"
#include "view/report.h"

namespace obby {

class Output {
 public:
  // Opens the output. Call it before reading, so that errors come at once. Errors: a file that
  // cannot be written, a picture for a terminal, an invalid --size.
  static Result<Output> open(const cli::Context& context);

  // Call it at most once. If it is not called, no file is left.
  Status write(const view::Report& report, cli::Context& context);

 private:
  explicit Output(io::Sink sink) : sink_(std::move(sink)) {}

  io::Sink sink_;
};

}  // namespace obby
