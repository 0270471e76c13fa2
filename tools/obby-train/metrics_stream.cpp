#include "metrics_stream.h"

#include <unistd.h>

#include "io/byte_source.h"
#include "io/sink.h"
#include "options.h"

namespace obby::tools {

namespace {

constexpr int kLookMilliseconds = 50;

Error unreadError(bool stopped) {
  if (stopped) return Error{"stdout", {}, {}, io::kInterrupted, {}};
  return Error{"stdout",
               {},
               {},
               "its reader takes nothing, and --time-limit is over: the last metrics are missing",
               "see what keeps the reader, or send the metrics to a file"};
}

}  // namespace

Result<MetricsStream> MetricsStream::open(const cli::Context& context) {
  OBBY_ASSIGN(io::StreamWriter output,
              io::StreamWriter::open("-", io::Format::jsonl, &context.stop()));
  io::SourceOptions nothing;
  nothing.inputs.clear();
  nothing.stop = &context.stop();
  MetricsStream out(context,
                    io::Pipeline(std::move(nothing), context.identity(), std::move(output)));
  if (!out.readerTakesMore()) return out;
  OBBY_RETURN_IF_ERROR(
      out.stream_.run([](const io::Record&) -> Result<io::Then> { return io::Then::pass; }));
  return out;
}

// Records are shorter than what there is room for then.
bool MetricsStream::readerTakesMore() const { return io::takesMore(STDOUT_FILENO, 0); }

bool MetricsStream::isOver() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
  return context_.stop() || passed.count() >= timeLimit(context_.arguments());
}

Status MetricsStream::waitForReader() {
  int late = 0;  // milliseconds
  while (!unread_ && !io::takesMore(STDOUT_FILENO, kLookMilliseconds)) {
    if (isOver()) late += kLookMilliseconds;
    if (late >= io::kPatienceMilliseconds) unread_ = unreadError(context_.stop());
  }
  return unread_ ? Status(*unread_) : Status();
}

Status MetricsStream::write(const char* source, uint64_t step,
                            std::span<const train::Metric> values) {
  io::RecordBuilder record;
  auto metrics = record.root().initMetrics();
  metrics.setSource(source);
  metrics.setStep(step);
  auto list = metrics.initValues(uint32_t(values.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    list[i].setName(values[i].name);
    list[i].setValue(values[i].value);
    list[i].setUnit(values[i].unit);
  }
  OBBY_RETURN_IF_ERROR(waitForReader());
  OBBY_RETURN_IF_ERROR(stream_.write(record.reader()));
  return stream_.output().flush();
}

Status MetricsStream::finish(Status work) {
  Status reader = waitForReader();
  if (!reader) return work ? std::move(reader) : std::move(work);
  return stream_.finish(std::move(work));
}

}  // namespace obby::tools
