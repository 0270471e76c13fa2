// obby-train: learns a policy from levels. Wiring only; lib/train does the work.
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <span>

#include "io/pipeline.h"
#include "io/read_file.h"
#include "options.h"
#include "policy/policy_file.h"
#include "shared/generated_levels.h"
#include "shared/recipe_options.h"
#include "streamed_levels.h"

namespace {

using namespace obby;
using Clock = std::chrono::steady_clock;

constexpr double kMetricsSeconds = 5, kSaveSeconds = 60;
// Levels to evaluate on are of another seed than those to learn from.
constexpr uint64_t kHeldOut = 0x68656c64;

struct NamedValue {
  const char* name;
  double value;
  const char* unit;
};

Status writeMetrics(io::StreamWriter& output, const char* source, uint64_t step,
                    std::span<const NamedValue> values) {
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
  OBBY_RETURN_IF_ERROR(output.write(record.reader()));
  return output.flush();
}

Result<std::unique_ptr<train::LevelSource>> levelSource(cli::Context& context, uint64_t seed) {
  const cli::Arguments& a = context.arguments();
  const bool makes = a.flag("generate") || a.has("style") || a.has("difficulty") || a.has("recipe");
  if (!makes) return tools::streamedLevels(context);
  OBBY_ASSIGN(gen::Recipe recipe, tools::recipeOf(a));
  if (!a.has("difficulty") && !a.has("recipe")) recipe.difficulty = {0, 1};
  return tools::generatedLevels(recipe, seed);
}

// What was asked for, as a command that asks for it again.
std::string commandOf(const cli::Arguments& arguments) {
  std::string command = "obby-train";
  for (const auto& [name, value] : arguments.values) {
    if (!value.given) continue;
    if (value.row.type == cli::ValueType::flag) {
      command += " --" + name;
      continue;
    }
    for (const std::string& text : value.texts) command += fmt::format(" --{} {}", name, text);
  }
  return command;
}

// A run of learning: what it has come to, and where that goes.
class Session {
 public:
  Session(cli::Context& context, train::Trainer& trainer, io::StreamWriter& output)
      : context_(context), trainer_(trainer), output_(output) {}

  Status run() {
    const cli::Arguments& a = context_.arguments();
    const auto most = uint64_t(a.integer("decisions"));
    const double mostSeconds = a.has("time-limit") ? a.number("time-limit") : 1e30;
    while (!context_.stop() && last_.decisions < most && seconds() < mostSeconds) {
      OBBY_ASSIGN(last_, trainer_.iterate());
      const double share =
          std::max(double(last_.decisions) / double(most), seconds() / mostSeconds);
      const double left = share > 0 ? seconds() * (1 - share) / share : 0;
      context_.progress({"learning",
                         share,
                         {{"decisions/s", rate()},
                          {"solved", last_.solved},
                          {"difficulty", double(last_.hardest)},
                          {"seconds left", left}}});
      if (seconds() - toldAt_ >= kMetricsSeconds) OBBY_RETURN_IF_ERROR(tell());
      if (seconds() - savedAt_ >= kSaveSeconds) OBBY_RETURN_IF_ERROR(save());
    }
    OBBY_RETURN_IF_ERROR(tell());
    return save();
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  double rate() const { return double(last_.decisions) / seconds(); }

  Status tell() {
    toldAt_ = seconds();
    const NamedValue values[] = {{"decisions", double(last_.decisions), ""},
                                 {"seconds", seconds(), "s"},
                                 {"decisionsPerSecond", rate(), "1/s"},
                                 {"solved", last_.solved, ""},
                                 {"hardest", double(last_.hardest), ""},
                                 {"reward", last_.reward, ""},
                                 {"entropy", last_.progress.entropy, "nat"},
                                 {"divergence", last_.progress.divergence, "nat"},
                                 {"clipped", last_.progress.clipped, ""},
                                 {"valueError", last_.progress.valueError, ""},
                                 {"gradient", last_.progress.norm, ""}};
    return writeMetrics(output_, "obby-train", last_.number, values);
  }

  Status save() {
    savedAt_ = seconds();
    const io::StreamIdentity identity = context_.identity();
    policy::PolicyFile file{trainer_.network(),
                            {commandOf(context_.arguments()), identity.version, identity.seed,
                             last_.decisions, seconds(), last_.hardest, float(last_.solved)}};
    OBBY_ASSIGN(io::Sink sink, io::Sink::open(context_.arguments().text("output")));
    OBBY_RETURN_IF_ERROR(sink.write(policy::writePolicy(file)));
    return sink.close();
  }

  cli::Context& context_;
  train::Trainer& trainer_;
  io::StreamWriter& output_;
  train::Iteration last_;
  Clock::time_point begin_ = Clock::now();
  double toldAt_ = 0, savedAt_ = 0;
};

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
  OBBY_ASSIGN(const auto source, levelSource(context, context.arguments().seed()));
  ThreadPool pool(context.threads());
  OBBY_ASSIGN(const auto trainer,
              train::Trainer::make(tools::trainerSettings(context), *source, pool));
  return withMetrics(
      context, [&](io::StreamWriter& output) { return Session(context, *trainer, output).run(); });
}

Status evaluate(cli::Context& context) {
  const std::string& path = context.arguments().text("eval");
  OBBY_ASSIGN(const std::string bytes, io::readFile(path));
  OBBY_ASSIGN(const policy::PolicyFile file, policy::readPolicy(bytes, path));
  OBBY_ASSIGN(const auto source, levelSource(context, context.arguments().seed() ^ kHeldOut));
  ThreadPool pool(context.threads());
  return withMetrics(context, [&](io::StreamWriter& output) -> Status {
    OBBY_ASSIGN(const train::Evaluation e,
                train::evaluate(file.network, *source, tools::evaluationSettings(context), pool,
                                context.stop()));
    const NamedValue values[] = {{"levels", double(e.levels), ""},
                                 {"solvedLikeliest", e.likeliest, ""},
                                 {"solvedDrawn", e.drawn, ""},
                                 {"solvedAny", e.any, ""}};
    return writeMetrics(output, "obby-train --eval", file.training.decisions, values);
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
