#include "metrics_stream.h"

#include <unistd.h>

#include "io/byte_source.h"
#include "io/metrics.h"
#include "io/sink.h"

namespace obby::tools {

namespace {

constexpr int kLookMilliseconds = 50;

}  // namespace

Result<MetricsStream> MetricsStream::open(const cli::Context& context,
                                          const std::atomic<bool>& late) {
  OBBY_ASSIGN(io::StreamWriter output,
              io::StreamWriter::open("-", io::Format::jsonl, &context.stop()));
  io::SourceOptions nothing;
  nothing.inputs.clear();
  nothing.stop = &context.stop();
  MetricsStream out(late, io::Pipeline(std::move(nothing), context.identity(), std::move(output)));
  if (!out.readerTakesMore()) return out;
  OBBY_RETURN_IF_ERROR(
      out.stream_.run([](const io::Record&) -> Result<io::Then> { return io::Then::pass; }));
  return out;
}

// Records are shorter than what there is room for then.
bool MetricsStream::readerTakesMore() const { return io::takesMore(STDOUT_FILENO, 0); }

Status MetricsStream::waitForReader() {
  int waited = 0;  // milliseconds
  while (!unread_ && !io::takesMore(STDOUT_FILENO, kLookMilliseconds)) {
    if (late_) waited += kLookMilliseconds;
    unread_ = waited >= io::kPatienceMilliseconds;
  }
  return unread_ ? Status(Error{"stdout", {}, {}, io::kInterrupted, {}}) : Status();
}

Status MetricsStream::write(const char* source, uint64_t step,
                            std::span<const train::Metric> values) {
  io::RecordBuilder record;
  io::setMetrics(record.root().initMetrics(), source, step, values);
  OBBY_RETURN_IF_ERROR(waitForReader());
  OBBY_RETURN_IF_ERROR(stream_.write(record.reader()));
  return stream_.output().flush();
}

Status MetricsStream::finish(const io::SourceSummary& levels, Status work) {
  Status reader = waitForReader();
  if (!reader) return work ? std::move(reader) : std::move(work);
  stream_.readElsewhere(levels);
  return stream_.finish(std::move(work));
}

}  // namespace obby::tools
