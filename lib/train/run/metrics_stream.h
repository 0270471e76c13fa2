// The metrics as a stream of records. Its reader may stall: training does not wait for it.
#pragma once

#include <atomic>
#include <functional>
#include <span>

#include "io/pipeline.h"
#include "train/run/metrics.h"

namespace obby::train {

class MetricsStream {
 public:
  struct Output {
    io::StreamWriter writer;
    // Returns true if the reader takes a record within this time, in milliseconds.
    std::function<bool(int)> takesMore;
  };

  // Writes the header at once if the reader takes it, otherwise before the first record. `late`:
  // once it is set, a reader that takes nothing for a second is given up. `stop` and `late` must
  // outlive this object.
  static Result<MetricsStream> open(Output output, const io::StreamIdentity& identity,
                                    const std::atomic<bool>& stop, const std::atomic<bool>& late);

  // Opens standard output.
  static Result<MetricsStream> toStandardOutput(const io::StreamIdentity& identity,
                                                const std::atomic<bool>& stop,
                                                const std::atomic<bool>& late);

  // Returns true if the reader takes a record at once.
  bool readerTakesMore() const { return takesMore_(0); }
  // Writes and flushes a record, and waits for the reader. Errors: those of the output;
  // io::isInterrupted() if the reader was given up.
  Status write(const char* source, uint64_t step, std::span<const Metric> values);
  void outOfBudget() { stream_.outOfBudget(); }
  // Like Pipeline::finish(), but waits as write() does. `levels`: counts for the end record.
  Status finish(const io::SourceSummary& levels, Status work = {});

 private:
  MetricsStream(const std::atomic<bool>& late, std::function<bool(int)> takesMore,
                io::Pipeline stream)
      : late_(late), takesMore_(std::move(takesMore)), stream_(std::move(stream)) {}

  Status waitForReader();

  const std::atomic<bool>& late_;
  std::function<bool(int)> takesMore_;
  io::Pipeline stream_;
  bool unread_ = false;  // the reader was given up
};

}  // namespace obby::train
