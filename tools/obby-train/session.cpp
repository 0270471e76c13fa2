#include "session.h"

#include <algorithm>

#include "io/read_file.h"
#include "io/sink.h"
#include "options.h"

namespace obby::tools {

namespace {

constexpr double kMetricsSeconds = 5;
constexpr double kPaceSeconds = 5;  // between two marks of the present rate

}  // namespace

Session::Session(cli::Context& context, train::Trainer& trainer, train::Ranks& ranks,
                 const Keeper& keeper, Logs logs, MetricsStream* output, train::WaitLimit& waiting)
    : context_(context),
      trainer_(trainer),
      ranks_(ranks),
      keeper_(keeper),
      logs_(std::move(logs)),
      output_(output),
      waiting_(waiting),
      decisionsBefore_(trainer.decisions()),
      most_(uint64_t(context.arguments().integer("decisions"))),
      mostSeconds_(timeLimit(context.arguments())),
      saveSeconds_(context.arguments().number("save-every")),
      pace_{{0, decisionsBefore_}, {0, decisionsBefore_}} {
  waiting_.begin();
}

double Session::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double Session::rate() const { return double(last_.decisions - decisionsBefore_) / seconds(); }

// Since the older mark, which is five to ten seconds back once there are two.
double Session::presentRate() {
  const double now = seconds();
  if (now - pace_[1].seconds >= kPaceSeconds) {
    pace_[0] = pace_[1];
    pace_[1] = {now, last_.decisions};
  }
  return double(last_.decisions - pace_[0].decisions) / (now - pace_[0].seconds);
}

Status Session::run() {
  while (true) {
    const Votes votes = vote();
    if (votes.save) OBBY_RETURN_IF_ERROR(saveMeanwhile());
    if (votes.stop) break;
    OBBY_ASSIGN(last_, trainer_.iterate());
    Status told = ranks_.agree(note());
    if (!told) return saveAfter(std::move(told));
    if (!trainer_.more()) break;
  }
  // Before anybody is waited for.
  Status saved = save();
  Status logged = ranks_.agree(output_ == nullptr ? Status() : logs_.finish());
  Status told = ranks_.agree(tell());
  OBBY_RETURN_IF_ERROR(std::move(saved));
  OBBY_RETURN_IF_ERROR(std::move(logged));
  OBBY_RETURN_IF_ERROR(std::move(told));
  return trainer_.more();
}

// A disk that is full for a minute does not end a day's learning: the next save may succeed, and
// the last one counts. But the first has to, for its place may be wrong; and who is gone from the
// other end of a pipe does not come back.
Status Session::saveMeanwhile() {
  Status saved = save();
  if (saved) {
    if (failing_ && ranks_.first()) context_.note("saving works again");
    saved_ = true;
    failing_ = false;
    return saved;
  }
  const bool forGood = io::isBrokenPipe(saved.error()) || io::isInterrupted(saved.error());
  double gone[] = {double(ranks_.first() && forGood)};  // the others have its words only
  ranks_.add(gone);
  if (!saved_ || gone[0] > 0) return saved;
  if (ranks_.first() && !failing_)
    context_.warn(saved.error().text() + "; training continues, and the next save tries again");
  failing_ = true;
  return {};
}

// Who could not be told, as at the end of a pipe that was closed: what was learned is kept.
Status Session::saveAfter(Status ended) {
  OBBY_RETURN_IF_ERROR(save());
  return ended;
}

// A signal may reach the ranks at different times, and their clocks differ: all do the same after
// the same iteration. The first rank's clock counts.
Session::Votes Session::vote() {
  const bool timeUp = seconds() >= mostSeconds_;
  const bool due = last_.number > 0 && seconds() - savedAt_ >= saveSeconds_;
  const bool stop = context_.stop() || waiting_.stop();
  double votes[] = {double(stop || (ranks_.first() && timeUp)), double(ranks_.first() && due)};
  ranks_.add(votes);
  return {votes[0] > 0 || trainer_.decisions() >= most_, votes[1] > 0};
}

// Says what came of an iteration. Learning does not wait for who reads no metrics now.
Status Session::note() {
  if (output_ == nullptr) return {};
  showProgress();
  OBBY_RETURN_IF_ERROR(logs_.add(last_, allSeconds(), rate(), last_.decisions >= most_));
  showHeldLogs();
  const bool due = seconds() - toldAt_ >= kMetricsSeconds;
  return due && output_->readerTakesMore() ? tell() : Status();
}

// Once, as of saves that fail.
void Session::showHeldLogs() {
  const Status held = logs_.held();
  if (!held && !logsHeld_)
    context_.warn(held.error().text() + "; training continues, and rows wait until there is space");
  if (held && logsHeld_) context_.note("the logs are complete again");
  logsHeld_ = !held;
}

void Session::showProgress() {
  const double toDo = double(most_ - decisionsBefore_);
  const double share =
      std::max(double(last_.decisions - decisionsBefore_) / toDo, seconds() / mostSeconds_);
  const double left = share > 0 ? std::max(seconds() * (1 - share) / share, 0.0) : 0;
  context_.progress({"learning",
                     std::max(double(last_.decisions) / double(most_), seconds() / mostSeconds_),
                     {{"decisions/s", presentRate()},
                      {"solved", last_.solved},
                      {"difficulty", double(last_.hardest)}},
                     left});
}

Status Session::tell() {
  if (output_ == nullptr || last_.number == told_) return {};
  toldAt_ = seconds();
  told_ = last_.number;
  return output_->write("obby-train", last_.number, train::metricsOf(last_, allSeconds(), rate()));
}

Status Session::save() {
  savedAt_ = seconds();
  OBBY_RETURN_IF_ERROR(ranks_.agree(keeper_.save(trainer_, logs_.history(), allSeconds())));
  return ranks_.agree(output_ == nullptr ? Status() : logs_.save());
}

}  // namespace obby::tools
