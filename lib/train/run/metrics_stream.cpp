#include "train/run/metrics_stream.h"

#include <unistd.h>

#include "io/byte_source.h"
#include "io/metrics.h"
#include "io/sink.h"

namespace obby::train {

namespace {

constexpr int kLookMilliseconds = 50;

}  // namespace

Result<MetricsStream> MetricsStream::toStandardOutput(const io::StreamIdentity& identity,
                                                      const std::atomic<bool>& stop,
                                                      const std::atomic<bool>& late) {
  OBBY_ASSIGN(io::StreamWriter writer, io::StreamWriter::open("-", io::Format::jsonl, &stop));
  // A pipe that takes more has capacity for a whole record.
  const auto takesMore = [](int wait) { return io::takesMore(STDOUT_FILENO, wait); };
  return open({std::move(writer), takesMore}, identity, stop, late);
}

Result<MetricsStream> MetricsStream::open(Output output, const io::StreamIdentity& identity,
                                          const std::atomic<bool>& stop,
                                          const std::atomic<bool>& late) {
  io::SourceOptions nothing;
  nothing.inputs.clear();
  nothing.stop = &stop;
  MetricsStream out(late, std::move(output.takesMore),
                    io::Pipeline(std::move(nothing), identity, std::move(output.writer)));
  if (!out.readerTakesMore()) return out;
  OBBY_RETURN_IF_ERROR(
      out.stream_.run([](const io::Record&) -> Result<io::Then> { return io::Then::pass; }));
  return out;
}

Status MetricsStream::waitForReader() {
  int waited = 0;  // milliseconds
  while (!unread_ && !takesMore_(kLookMilliseconds)) {
    if (late_) waited += kLookMilliseconds;
    unread_ = waited >= io::kPatienceMilliseconds;
  }
  return unread_ ? Status(Error{"stdout", {}, {}, io::kInterrupted, {}}) : Status();
}

Status MetricsStream::write(const char* source, uint64_t step, std::span<const Metric> values) {
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

}  // namespace obby::train
