// obby-train: learns a policy from levels. Wiring only; lib/train does the work.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <optional>

#include "cli/console.h"
#include "cli/written_files.h"
#include "evaluation_metrics.h"
#include "io/read_file.h"
#include "keeper.h"
#include "levels.h"
#include "metrics_stream.h"
#include "mpi/join_ranks.h"
#include "nccl/join_devices.h"
#include "options.h"
#include "policy/policy_file.h"
#include "same_options.h"
#include "session.h"
#include "train/device/device_engine.h"

namespace {

using namespace obby;
// Levels to evaluate on are of another seed than those to learn from.
constexpr uint64_t kHeldOut = 0x68656c64;

// Interrupted while it waited for the first levels.
Status nothingLearned(cli::Context& context) {
  OBBY_ASSIGN(tools::MetricsStream stream, tools::MetricsStream::open(context, context.stop()));
  return stream.finish({.skipped = context.errors(), .errors = context.errors()});
}

// Where to learn. `direct`: how ranks exchange gradients on devices.
std::unique_ptr<train::Engine> engineOf(const train::TrainerSettings& settings,
                                        const train::LevelSource& source,
                                        const sim::Backend& backend, ThreadPool& pool,
                                        train::Ranks& ranks, train::DeviceRanks* direct) {
  if (!backend.onDevice()) return train::makeCpuEngine(settings, source, pool, ranks);
  return train::makeDeviceEngine(settings, source, *backend.device(), pool, ranks, direct);
}

// Ranks whose GPUs cannot join, as several on one GPU, go through the host.
std::unique_ptr<train::DeviceRanks> directOf(cli::Context& context, const sim::Backend& backend,
                                             train::Ranks& ranks) {
  if (!backend.onDevice()) return nullptr;
  auto direct = tools::joinDevices(ranks);
  if (direct) return *std::move(direct);
  if (ranks.first()) context.note(direct.error().text() + "; gradients go through the host");
  return nullptr;
}

Status learn(cli::Context& context, tools::JoinedRanks& joined) {
  signal(SIGPIPE, SIG_IGN);  // who stops reading the metrics does not end learning unsaved
  train::Ranks& ranks = joined.ranks();
  const cli::Arguments& a = context.arguments();
  train::WaitLimit waiting(context.stop(), tools::timeLimit(a));
  tools::Keeper keeper(context, ranks, waiting.lost());
  OBBY_RETURN_IF_ERROR(keeper.find());
  auto found = ranks.agree(tools::levelsOf(context, ranks, a.seed(), true, waiting));
  if (!found && ranks.first() && context.stop()) return nothingLearned(context);
  OBBY_ASSIGN(const tools::Levels levels, std::move(found));
  OBBY_ASSIGN(const sim::Backend backend,
              ranks.agree(tools::trainBackend(context, joined.neighbour())));
  if (ranks.first()) context.note(backend.note());
  const train::TrainerSettings settings = tools::trainerSettings(context);
  OBBY_RETURN_IF_ERROR(keeper.setRun(settings, levels.settings, backend.onDevice()));
  ThreadPool pool(context.threads());
  const auto direct = directOf(context, backend, ranks);
  auto made =
      keeper.trainer(engineOf(settings, *levels.source, backend, pool, ranks, direct.get()));
  if (!made && ranks.count() == 1 && context.stop()) return nothingLearned(context);
  if (!made && waiting.isUp()) return tools::lateStream();
  OBBY_ASSIGN(const auto trainer, std::move(made));
  tools::Logs logs;
  std::optional<tools::MetricsStream> stream;  // the first rank's; an error before it leaves none
  const auto open = [&]() -> Status {
    OBBY_ASSIGN(
        logs, tools::Logs::open(a, waiting.late(), trainer->iterations(), keeper.historyBefore()));
    OBBY_ASSIGN(tools::MetricsStream opened, tools::MetricsStream::open(context, waiting.late()));
    stream.emplace(std::move(opened));
    return {};
  };
  waiting.begin();  // a log may wait for its reader to begin with
  OBBY_RETURN_IF_ERROR(ranks.agree(ranks.first() ? open() : Status()));
  tools::Session session(context, *trainer, ranks, keeper, std::move(logs),
                         stream ? &*stream : nullptr, waiting);
  Status done = session.run();
  waiting.end();
  return stream ? stream->finish(levels.summary(), std::move(done)) : done;
}

// Nobody knows how many levels a stream has.
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
    return Error{{}, {}, "--eval", "cannot run with several ranks", "start it without mpirun"};
  const cli::Arguments& a = context.arguments();
  const cli::WrittenFile metrics[] = {{"", "-"}};
  OBBY_RETURN_IF_ERROR(cli::refuseOverwriting(a, metrics));
  const std::string& path = a.text("eval");
  OBBY_ASSIGN(const std::string bytes, io::readFile(path, &context.stop()));
  OBBY_ASSIGN(const policy::PolicyFile file, policy::readPolicy(bytes, path));
  train::WaitLimit waiting(context.stop(), tools::timeLimit(a));
  OBBY_ASSIGN(const tools::Levels levels,
              tools::levelsOf(context, ranks, a.seed() ^ kHeldOut, false, waiting));
  ThreadPool pool(context.threads());
  OBBY_ASSIGN(tools::MetricsStream stream, tools::MetricsStream::open(context, waiting.late()));
  const train::EvaluationSettings settings = tools::evaluationSettings(context);
  waiting.begin();
  const train::Evaluation e = train::evaluate(
      file.network, *levels.source, settings, pool, context.stop(),
      [&](const train::EvaluationSoFar& soFar) { showPlayed(context, settings.levels, soFar); },
      tools::styleNumberOf);
  if (e.timeUp || waiting.isUp()) stream.outOfBudget();
  // A level that could not be read takes nothing from those that were played.
  Status done;
  if (e.levels > 0 || e.missing)
    done = stream.write("obby-train --eval", file.training.decisions,
                        tools::evaluationMetrics(e, settings.tries));
  if (done) done = e.missing;
  return stream.finish(levels.summary(), std::move(done));
}

// Whoever takes nothing is given up as after a signal, but it may be the time that is over.
Status readersKnown(Status done, const cli::Context& context) {
  if (done || !io::isInterrupted(done.error()) || context.stop()) return done;
  return Error{
      done.error().input,
      {},
      {},
      "the reader stopped reading and the --time-limit ran out: the last records are missing",
      "check what delays the reader, or write to a file"};
}

// An error that all ranks know of is told by the first.
Result<cli::ExitCode> run(cli::Context& context, tools::JoinedRanks& joined) {
  train::Ranks& ranks = joined.ranks();
  Status done = tools::sameOptions(context.arguments(), ranks);  // before they take other ways
  if (done) done = ranks.agree(tools::optionsFit(context.arguments()));
  if (done)
    done = context.arguments().has("eval") ? evaluate(context, ranks) : learn(context, joined);
  if (!done && !ranks.first()) return cli::ExitCode::failed;
  OBBY_RETURN_IF_ERROR(readersKnown(std::move(done), context));
  return cli::ExitCode::ok;
}

// A standard stream that goes nowhere while this lives.
class Silence {
 public:
  explicit Silence(int stream) : stream_(stream), kept_(dup(stream)) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, stream_);
    close(nowhere);
  }
  ~Silence() {
    dup2(kept_, stream_);
    close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int stream_, kept_;
};

int runRank(int argc, char** argv, tools::JoinedRanks& joined) {
  train::Ranks& ranks = joined.ranks();
  // Help, and what is wrong with the options, are the same on every rank: the first one says it.
  // Later each may say how it dies.
  std::optional<Silence> silent, mute;
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
  if (begun && !ended) joined.abandon(code);  // it threw: the others wait for it
  if (begun) return code;
  // The others compare their options with what this one was told; where the first has done what it
  // was asked for, nobody has said what is wrong.
  const bool refused = code != int(cli::ExitCode::ok);
  const Status same = tools::noOptions(refused, ranks);
  if (same) return code;
  if (ranks.first() && !refused) cli::Console(spec.name).error(same.error());
  return int(cli::ExitCode::failed);
}

}  // namespace

int main(int argc, char** argv) {
  const auto joined = obby::tools::joinRanks(&argc, &argv);
  if (joined) return runRank(argc, argv, **joined);
  return obby::cli::runTool(
      obby::tools::trainSpec(), argc, argv,
      [&](obby::cli::Context&) -> obby::Result<obby::cli::ExitCode> { return joined.error(); });
}
