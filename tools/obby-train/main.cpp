// obby-train: learns a policy from levels. Wiring only; lib/train does the work.
#include <functional>

#include "io/pipeline.h"
#include "io/read_file.h"
#include "keeper.h"
#include "levels.h"
#include "metric_records.h"
#include "options.h"
#include "policy/policy_file.h"
#include "session.h"

namespace {

using namespace obby;
// Levels to evaluate on are of another seed than those to learn from.
constexpr uint64_t kHeldOut = 0x68656c64;

// The stream of metrics. What can go wrong before the work begins leaves none.
Status withMetrics(cli::Context& context, const std::function<Status(io::StreamWriter&)>& work) {
  OBBY_ASSIGN(io::StreamWriter output, io::StreamWriter::open("-", io::Format::jsonl));
  io::SourceOptions nothing;
  nothing.inputs.clear();
  nothing.stop = &context.stop();
  io::Pipeline pipeline(std::move(nothing), context.identity(), std::move(output));
  OBBY_RETURN_IF_ERROR(
      pipeline.run([](const io::Record&) -> Result<io::Then> { return io::Then::pass; }));
  Status done = work(pipeline.output());
  if (!done) pipeline.outOfBudget();
  const Status finished = pipeline.finish();
  OBBY_RETURN_IF_ERROR(std::move(done));
  return finished;
}

Status learn(cli::Context& context) {
  tools::Keeper keeper(context);
  OBBY_RETURN_IF_ERROR(keeper.find());
  OBBY_ASSIGN(const tools::Levels levels, tools::levelsOf(context, context.arguments().seed()));
  keeper.setRun(tools::trainerSettings(context), levels.settings);
  ThreadPool pool(context.threads());
  OBBY_ASSIGN(const auto trainer, keeper.trainer(*levels.source, pool));
  OBBY_ASSIGN(tools::Logs logs, tools::Logs::open(context.arguments(), trainer->iterations(),
                                                  keeper.historyBefore()));
  return withMetrics(context, [&](io::StreamWriter& output) {
    return tools::Session(context, *trainer, keeper, std::move(logs), output).run();
  });
}

Status evaluate(cli::Context& context) {
  const std::string& path = context.arguments().text("eval");
  OBBY_ASSIGN(const std::string bytes, io::readFile(path));
  OBBY_ASSIGN(const policy::PolicyFile file, policy::readPolicy(bytes, path));
  OBBY_ASSIGN(const tools::Levels levels,
              tools::levelsOf(context, context.arguments().seed() ^ kHeldOut));
  ThreadPool pool(context.threads());
  return withMetrics(context, [&](io::StreamWriter& output) -> Status {
    OBBY_ASSIGN(const train::Evaluation e,
                train::evaluate(file.network, *levels.source, tools::evaluationSettings(context),
                                pool, context.stop()));
    const train::Metric values[] = {{"levels", double(e.levels), ""},
                                    {"solvedLikeliest", e.likeliest, ""},
                                    {"solvedDrawn", e.drawn, ""},
                                    {"solvedAny", e.any, ""}};
    return tools::writeMetrics(output, "obby-train --eval", file.training.decisions, values);
  });
}

Result<cli::ExitCode> run(cli::Context& context) {
  OBBY_RETURN_IF_ERROR(context.arguments().has("eval") ? evaluate(context) : learn(context));
  return cli::ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::tools::trainSpec(), argc, argv, run);
}
