#include "logs.h"

#include "io/sink.h"

namespace obby::tools {

Result<Logs> Logs::open(const cli::Arguments& a, const std::atomic<bool>& late, uint64_t kept,
                        train::History history) {
  Logs logs;
  logs.late_ = &late;
  logs.history_ = std::move(history);
  logs.curvePath_ = a.text("curve");
  logs.every_ = uint64_t(a.integer("log-every"));
  if (a.has("log")) {
    OBBY_ASSIGN(logs.csv_, train::CsvLog::open(a.text("log"), kept, logs.late_));
  }
  if (a.has("tensorboard")) {
    OBBY_ASSIGN(logs.events_, train::EventLog::open(a.text("tensorboard"), kept));
  }
  return logs;
}

Status Logs::add(const train::Iteration& iteration, double seconds, double rate, bool last) {
  history_.add(iteration);
  if (iteration.number % every_ != 0 && !last) return {};
  const auto metrics = train::metricsOf(iteration, seconds, rate);
  if (csv_) OBBY_RETURN_IF_ERROR(csv_->add(iteration.number, metrics));
  if (events_) OBBY_RETURN_IF_ERROR(events_->add(iteration.number, metrics));
  return {};
}

Status Logs::held() {
  Status csv = csv_ ? csv_->file().held() : Status();
  return csv && events_ ? events_->file().held() : csv;
}

Status Logs::finish() {
  Status csv = csv_ ? csv_->file().finish() : Status();
  Status events = events_ ? events_->file().finish() : Status();
  return csv ? events : csv;
}

Status Logs::save() const {
  if (curvePath_.empty()) return {};
  OBBY_ASSIGN(io::Sink sink, io::Sink::open(curvePath_, io::Durable::no, late_));
  OBBY_RETURN_IF_ERROR(sink.write(train::curveSvg(history_)));
  return sink.close();
}

}  // namespace obby::tools
