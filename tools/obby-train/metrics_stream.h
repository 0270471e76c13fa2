// The metrics on standard output, a stream of records. Its reader may stop reading and stay there:
// no work is held up or lost for that.
#pragma once

#include <atomic>
#include <span>

#include "cli/context.h"
#include "io/pipeline.h"
#include "train/metrics.h"

namespace obby::tools {

class MetricsStream {
 public:
  // The header goes out at once where the reader takes it, otherwise before the first record.
  // `context` and `late` must outlive it.
  static Result<MetricsStream> open(const cli::Context& context, const std::atomic<bool>& late);

  // Would the reader take a record at once?
  bool readerTakesMore() const;
  // A record, flushed. Waits for the reader, but only for a second once `late` is set. The error is
  // that, io::isInterrupted(), or the output's.
  Status write(const char* source, uint64_t step, std::span<const train::Metric> values);
  void outOfBudget() { stream_.outOfBudget(); }
  // As Pipeline::finish(); waits as write() does. `levels`: what came of their records, which the
  // end record says, too.
  Status finish(const io::SourceSummary& levels, Status work = {});

 private:
  MetricsStream(const std::atomic<bool>& late, io::Pipeline stream)
      : late_(late), stream_(std::move(stream)) {}

  Status waitForReader();

  const std::atomic<bool>& late_;
  io::Pipeline stream_;
  bool unread_ = false;  // the reader was given up
};

}  // namespace obby::tools
