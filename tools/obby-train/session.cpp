#include "session.h"

#include <algorithm>

#include "metric_records.h"

namespace obby::tools {

namespace {

constexpr double kMetricsSeconds = 5;

}  // namespace

Session::Session(cli::Context& context, train::Trainer& trainer, const Keeper& keeper, Logs logs,
                 io::StreamWriter& output)
    : context_(context),
      trainer_(trainer),
      keeper_(keeper),
      logs_(std::move(logs)),
      output_(output),
      decisionsBefore_(trainer.decisions()),
      most_(uint64_t(context.arguments().integer("decisions"))) {}

double Session::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double Session::rate() const { return double(last_.decisions - decisionsBefore_) / seconds(); }

Status Session::run() {
  const cli::Arguments& a = context_.arguments();
  const double mostSeconds = a.has("time-limit") ? a.number("time-limit") : 1e30;
  const double saveSeconds = a.number("save-every");
  while (!context_.stop() && trainer_.decisions() < most_ && seconds() < mostSeconds) {
    OBBY_ASSIGN(last_, trainer_.iterate());
    showProgress(mostSeconds);
    OBBY_RETURN_IF_ERROR(logs_.add(last_, allSeconds(), rate(), last_.decisions >= most_));
    if (seconds() - toldAt_ >= kMetricsSeconds) OBBY_RETURN_IF_ERROR(tell());
    if (seconds() - savedAt_ >= saveSeconds) OBBY_RETURN_IF_ERROR(save());
  }
  if (last_.number > 0) OBBY_RETURN_IF_ERROR(tell());
  return save();
}

void Session::showProgress(double mostSeconds) {
  const double toDo = double(most_ - decisionsBefore_);
  const double share =
      std::max(double(last_.decisions - decisionsBefore_) / toDo, seconds() / mostSeconds);
  const double left = share > 0 ? std::max(seconds() * (1 - share) / share, 0.0) : 0;
  context_.progress({"learning",
                     std::max(double(last_.decisions) / double(most_), seconds() / mostSeconds),
                     {{"decisions/s", rate()},
                      {"solved", last_.solved},
                      {"difficulty", double(last_.hardest)},
                      {"seconds left", left}}});
}

Status Session::tell() {
  toldAt_ = seconds();
  return writeMetrics(output_, "obby-train", last_.number,
                      train::metricsOf(last_, allSeconds(), rate()));
}

Status Session::save() {
  savedAt_ = seconds();
  OBBY_RETURN_IF_ERROR(keeper_.save(trainer_, logs_.history(), allSeconds()));
  return logs_.save();
}

}  // namespace obby::tools
