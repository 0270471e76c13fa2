#include "train/run/training_run.h"

#include <algorithm>
#include <utility>

#include "io/read_file.h"
#include "io/sink.h"

namespace obby::train {

namespace {

constexpr double kMetricsSeconds = 5;
constexpr double kPaceSeconds = 5;  // between two marks

}  // namespace

TrainingRun::TrainingRun(Trainer& trainer, Ranks& ranks, const CheckpointStore& store,
                         RunLimits limits, RunOutputs outputs, const RunReport& report,
                         Timeout& timeout)
    : trainer_(trainer),
      ranks_(ranks),
      store_(store),
      limits_(limits),
      outputs_(outputs),
      report_(report),
      timeout_(timeout),
      decisionsBefore_(trainer.decisions()),
      pace_{{0, decisionsBefore_}, {0, decisionsBefore_}} {
  timeout_.begin();
}

double TrainingRun::meanRate() const {
  return double(last_.decisions - decisionsBefore_) / seconds();
}

// Returns the rate since the older mark, which is five to ten seconds old once there are two.
double TrainingRun::presentRate() {
  const double now = seconds();
  if (now - pace_[1].seconds >= kPaceSeconds) {
    pace_[0] = pace_[1];
    pace_[1] = {now, last_.decisions};
  }
  return double(last_.decisions - pace_[0].decisions) / (now - pace_[0].seconds);
}

Status TrainingRun::run() {
  while (true) {
    const Votes votes = vote();
    if (votes.save) OBBY_RETURN_IF_ERROR(saveMeanwhile());
    if (votes.stop) break;
    OBBY_ASSIGN(last_, trainer_.iterate());
    Status reported = ranks_.agree(report());
    if (!reported) return saveAfter(std::move(reported));
    if (!trainer_.more()) break;
  }
  Status saved = save();  // before the run waits for any reader
  Status logged = ranks_.agree(outputs_.events == nullptr ? Status() : outputs_.events->finish());
  Status written = ranks_.agree(writeMetrics());
  OBBY_RETURN_IF_ERROR(std::move(saved));
  OBBY_RETURN_IF_ERROR(std::move(logged));
  OBBY_RETURN_IF_ERROR(std::move(written));
  return trainer_.more();
}

// A disk that is full for a minute does not end a day of training, because the next save may
// succeed. The first save must succeed, since its path may be wrong, and a closed pipe stays
// closed.
Status TrainingRun::saveMeanwhile() {
  Status saved = save();
  if (saved) {
    if (failing_ && ranks_.first())
      report_.note("the checkpoint and the policy can be saved again");
    saved_ = true;
    failing_ = false;
    return saved;
  }
  const bool readerGone = io::isBrokenPipe(saved.error()) || io::isInterrupted(saved.error());
  // Other ranks have only the text of the error.
  double votes[] = {double(ranks_.first() && readerGone)};
  ranks_.add(votes);
  if (!saved_ || votes[0] > 0) return saved;
  if (ranks_.first() && !failing_)
    report_.warn(saved.error().text() + "; training continues, and saving is tried again later");
  failing_ = true;
  return {};
}

// Saves the training so far if the metrics could not be written, and returns their error.
Status TrainingRun::saveAfter(Status ended) {
  OBBY_RETURN_IF_ERROR(save());
  return ended;
}

// A signal may reach the ranks at different times, and their clocks differ, so they vote. The first
// rank's clock counts.
TrainingRun::Votes TrainingRun::vote() {
  const bool timeUp = seconds() >= limits_.seconds;
  const bool due = last_.number > 0 && seconds() - savedAt_ >= limits_.saveSeconds;
  double votes[] = {double(timeout_.stop() || (ranks_.first() && timeUp)),
                    double(ranks_.first() && due)};
  ranks_.add(votes);
  return {votes[0] > 0 || trainer_.decisions() >= limits_.decisions, votes[1] > 0};
}

// Reports an iteration. Training does not wait for a reader that is not ready for metrics.
Status TrainingRun::report() {
  if (outputs_.metrics == nullptr) return {};
  reportProgress();
  const bool done = last_.decisions >= limits_.decisions;
  if (outputs_.events != nullptr && (last_.number % limits_.eventsEvery == 0 || done))
    outputs_.events->add(last_.number, metricsOf(last_, allSeconds(), meanRate()));
  reportHeldEvents();
  const bool due = seconds() - metricsAt_ >= kMetricsSeconds;
  return due && outputs_.metrics->readerTakesMore() ? writeMetrics() : Status();
}

// Warns once when events are held back, and again only after the log has been complete.
void TrainingRun::reportHeldEvents() {
  if (outputs_.events == nullptr) return;
  const Status& held = outputs_.events->held();
  if (!held && !eventsHeld_)
    report_.warn(held.error().text() +
                 "; training continues, and the events are written once writing succeeds");
  if (held && eventsHeld_) report_.note("the TensorBoard log is complete again");
  eventsHeld_ = !held;
}

void TrainingRun::reportProgress() {
  const double now = seconds(), timeShare = now / limits_.seconds;
  const double toDo = double(limits_.decisions - decisionsBefore_);
  const double share = std::max(double(last_.decisions - decisionsBefore_) / toDo, timeShare);
  report_.progress({std::max(double(last_.decisions) / double(limits_.decisions), timeShare),
                    share > 0 ? std::max(now * (1 - share) / share, 0.0) : 0, presentRate(),
                    last_.solved, double(last_.hardest)});
}

Status TrainingRun::writeMetrics() {
  if (outputs_.metrics == nullptr || last_.number == metricsOf_) return {};
  metricsAt_ = seconds();
  metricsOf_ = last_.number;
  return outputs_.metrics->write("obby-train", last_.number,
                                 metricsOf(last_, allSeconds(), meanRate()));
}

Status TrainingRun::save() {
  savedAt_ = seconds();
  return ranks_.agree(store_.save(trainer_, allSeconds()));
}

Status runTraining(Trainer& trainer, Ranks& ranks, const CheckpointStore& store,
                   const Levels& levels, const RunPlan& plan, const RunReport& report,
                   const std::atomic<bool>& stop, Timeout& timeout) {
  std::optional<EventLog> events;
  std::optional<MetricsStream> metrics;  // stays empty if an earlier output fails
  const auto open = [&]() -> Status {
    if (!plan.eventFolder.empty()) {
      OBBY_ASSIGN(events, EventLog::open(plan.eventFolder, trainer.iterations()));
    }
    OBBY_ASSIGN(MetricsStream opened,
                MetricsStream::toStandardOutput(plan.identity, stop, timeout.late()));
    metrics.emplace(std::move(opened));
    return {};
  };
  OBBY_RETURN_IF_ERROR(ranks.agree(ranks.first() ? open() : Status()));
  const RunOutputs outputs{metrics ? &*metrics : nullptr, events ? &*events : nullptr};
  TrainingRun run(trainer, ranks, store, plan.limits, outputs, report, timeout);
  Status done = run.run();
  timeout.end();
  return metrics ? metrics->finish(levels.summary(), std::move(done)) : done;
}

}  // namespace obby::train
