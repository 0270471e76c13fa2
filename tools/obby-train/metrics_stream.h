// The metrics on standard output, a stream of records. Its reader may stop reading and stay there:
// no work is held up or lost for that.
#pragma once

#include <chrono>
#include <optional>
#include <span>

#include "cli/context.h"
#include "io/pipeline.h"
#include "train/metrics.h"

namespace obby::tools {

class MetricsStream {
 public:
  // The header goes out at once where the reader takes it, otherwise before the first record.
  // `context` must outlive it; its --time-limit begins here.
  static Result<MetricsStream> open(const cli::Context& context);

  // Would the reader take a record at once?
  bool readerTakesMore() const;
  // A record, flushed. Waits for the reader, but only for a second once the tool was told to stop
  // or --time-limit is over. The error is that, or the output's.
  Status write(const char* source, uint64_t step, std::span<const train::Metric> values);
  void outOfBudget() { stream_.outOfBudget(); }
  // As Pipeline::finish(); waits as write() does.
  Status finish(Status work = {});

 private:
  MetricsStream(const cli::Context& context, io::Pipeline stream)
      : context_(context), stream_(std::move(stream)) {}

  bool isOver() const;
  Status waitForReader();

  const cli::Context& context_;
  io::Pipeline stream_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::optional<Error> unread_;  // the reader was given up
};

}  // namespace obby::tools
