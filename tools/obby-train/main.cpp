// obby-train: trains a policy on levels. Wiring only; lib/train does the work.
#include <signal.h>
#include <unistd.h>

#include <optional>

#include "cli/console.h"
#include "cli/silence.h"
#include "io/read_file.h"
#include "levels.h"
#include "options.h"
#include "policy/policy_file.h"
#include "shared/generated_levels.h"
#include "train/device/device_engine.h"
#include "train/run/metrics.h"
#include "train/run/rank_options.h"
#include "train/run/ranks/join_devices.h"
#include "train/run/ranks/join_ranks.h"
#include "train/run/training_run.h"

namespace {

using namespace obby;

constexpr uint64_t kHeldOut = 0x68656c64;  // changes the seed, so that evaluation has other levels

// Ends a run that was interrupted while it waited for the first levels.
Status nothingTrained(cli::Context& context) {
  OBBY_ASSIGN(auto stream, train::MetricsStream::toStandardOutput(context.identity(),
                                                                  context.stop(), context.stop()));
  return stream.finish({.skipped = context.errors(), .errors = context.errors()});
}

// Ranks whose GPUs cannot join, such as several on one GPU, exchange gradients through the host.
std::unique_ptr<train::DeviceRanks> directOf(cli::Context& context, const sim::Backend& backend,
                                             train::Ranks& ranks) {
  if (!backend.onDevice()) return nullptr;
  auto direct = train::joinDevices(ranks);
  if (direct) return *std::move(direct);
  if (ranks.first())
    context.note(direct.error().text() + "; the ranks exchange gradients through the host");
  return nullptr;
}

train::RunReport reportTo(cli::Context& context) {
  return {[&](const std::string& text) { context.warn(text); },
          [&](const std::string& text) { context.note(text); },
          [&](const train::RunProgress& p) {
            context.progress({"learning",
                              p.share,
                              {{"decisions/s", p.decisionsPerSecond},
                               {"solved", p.solved},
                               {"difficulty", p.hardest}},
                              p.secondsLeft});
          }};
}

Status learn(cli::Context& context, train::JoinedRanks& joined) {
  signal(SIGPIPE, SIG_IGN);  // if the reader of the metrics goes away, training is still saved
  train::Ranks& ranks = joined.ranks();
  const cli::Arguments& a = context.arguments();
  OBBY_RETURN_IF_ERROR(ranks.agree(ranks.first() ? tools::filesFit(a) : Status()));
  train::Timeout timeout(context.stop(), tools::timeLimit(a));
  train::CheckpointStore store(tools::runFiles(a), tools::runIdentity(context), ranks,
                               context.stop(), timeout.late());
  OBBY_RETURN_IF_ERROR(store.open());
  auto found = ranks.agree(tools::levelsOf(context, ranks, a.seed(), true, timeout));
  if (!found && ranks.first() && context.stop()) return nothingTrained(context);
  OBBY_ASSIGN(const train::Levels levels, std::move(found));
  OBBY_ASSIGN(const sim::Backend backend,
              ranks.agree(tools::trainBackend(context, joined.neighbour())));
  if (ranks.first()) context.note(backend.note());
  const train::TrainerSettings settings = tools::trainerSettings(a);
  OBBY_RETURN_IF_ERROR(store.setRun(settings, levels.settings, backend.onDevice()));
  ThreadPool pool(context.threads());
  const auto direct = directOf(context, backend, ranks);
  auto made = store.trainer(
      train::makeEngine(settings, *levels.source, backend.device(), pool, ranks, direct.get()));
  if (!made && ranks.count() == 1 && context.stop()) return nothingTrained(context);
  if (!made && timeout.expired()) return train::lateStream();
  OBBY_ASSIGN(const auto trainer, std::move(made));
  return train::runTraining(*trainer, ranks, store, levels, tools::runPlan(context),
                            reportTo(context), context.stop(), timeout);
}

// Shows the progress of an evaluation. The number of levels of a stream is unknown.
void showPlayed(cli::Context& context, uint32_t levels, const train::EvaluationSoFar& e) {
  cli::ProgressState state{"evaluating", -1, {{"levels", double(e.levels)}}};
  if (tools::makesLevels(context.arguments())) {
    state.fraction = e.done;
    state.numbers.push_back({"of", double(levels)});
  }
  state.numbers.push_back({"solved", e.likeliest});
  context.progress(state);
}

Status evaluate(cli::Context& context, train::Ranks& ranks) {
  if (ranks.count() > 1)
    return Error{{},
                 {},
                 "--eval",
                 "cannot be combined with several ranks",
                 "start obby-train without mpirun"};
  const cli::Arguments& a = context.arguments();
  OBBY_RETURN_IF_ERROR(tools::filesFit(a));
  const std::string& path = a.text("eval");
  OBBY_ASSIGN(const std::string bytes, io::readFile(path, &context.stop()));
  OBBY_ASSIGN(const policy::PolicyFile file, policy::readPolicy(bytes, path));
  train::Timeout timeout(context.stop(), tools::timeLimit(a));
  OBBY_ASSIGN(const train::Levels levels,
              tools::levelsOf(context, ranks, a.seed() ^ kHeldOut, false, timeout));
  ThreadPool pool(context.threads());
  OBBY_ASSIGN(auto stream, train::MetricsStream::toStandardOutput(context.identity(),
                                                                  context.stop(), timeout.late()));
  const train::EvaluationSettings settings = tools::evaluationSettings(a);
  timeout.begin();
  const train::Evaluation e = train::evaluate(
      file.network, *levels.source, settings, pool, context.stop(),
      [&](const train::EvaluationSoFar& soFar) { showPlayed(context, settings.levels, soFar); },
      tools::styleNumberOf);
  if (e.timeUp || timeout.expired()) stream.outOfBudget();
  // Levels that were played count even if another could not be read.
  Status done;
  if (e.levels > 0 || e.missing)
    done = stream.write("obby-train --eval", file.training.decisions,
                        train::evaluationMetrics(e, settings.tries, tools::styleNames()));
  if (done) done = e.missing;
  return stream.finish(levels.summary(), std::move(done));
}

// An interrupted write without a signal means that the time limit gave up a reader.
Status explained(Status done, const cli::Context& context) {
  if (done || !io::isInterrupted(done.error()) || context.stop()) return done;
  return Error{done.error().input,
               {},
               {},
               "the last records are missing: the program that reads the output had stopped "
               "reading when --time-limit ran out",
               "check that program, or write the output to a file"};
}

// All ranks return the same error, but only the first one reports it.
Result<cli::ExitCode> run(cli::Context& context, train::JoinedRanks& joined) {
  train::Ranks& ranks = joined.ranks();
  const cli::Arguments& a = context.arguments();
  Status done = train::sameOptions(tools::rankOptions(a), ranks);
  if (done) done = ranks.agree(tools::optionsFit(a));
  if (done) done = a.has("eval") ? evaluate(context, ranks) : learn(context, joined);
  if (!done && !ranks.first()) return cli::ExitCode::failed;
  OBBY_RETURN_IF_ERROR(explained(std::move(done), context));
  return cli::ExitCode::ok;
}

int runRank(int argc, char** argv, train::JoinedRanks& joined) {
  train::Ranks& ranks = joined.ranks();
  // Only the first rank prints help and errors of options, which are the same on every rank. Later
  // each rank may print its own errors.
  std::optional<cli::Silence> silent, mute;
  if (!ranks.first()) {
    silent.emplace(STDERR_FILENO);
    mute.emplace(STDOUT_FILENO);
  }
  bool begun = false, ended = false;
  const cli::ToolSpec spec = tools::trainSpec();
  const int code = cli::runTool(spec, argc, argv, [&](cli::Context& context) {
    begun = true;
    silent.reset();
    auto result = run(context, joined);
    ended = true;
    return result;
  });
  if (begun && !ended) joined.abandon(code);  // run() threw, and the other ranks wait for this one
  if (begun) return code;
  // Tells the other ranks that this one does not run. If it has no error of its own, it reports
  // theirs.
  const bool refused = code != int(cli::ExitCode::ok);
  const Status same = train::notRunning(refused, ranks);
  if (same) return code;
  if (ranks.first() && !refused) cli::Console(spec.name).error(same.error());
  return int(cli::ExitCode::failed);
}

}  // namespace

int main(int argc, char** argv) {
  const auto joined = obby::train::joinRanks(&argc, &argv);
  if (joined) return runRank(argc, argv, **joined);
  return obby::cli::runTool(
      obby::tools::trainSpec(), argc, argv,
      [&](obby::cli::Context&) -> obby::Result<obby::cli::ExitCode> { return joined.error(); });
}
