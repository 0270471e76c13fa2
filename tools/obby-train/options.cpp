// The option table of obby-train and what its options mean to lib/train.
#include "options.h"

#include <fmt/format.h>

#include "cli/rows.h"
#include "levels.h"
#include "shared/recipe_options.h"
#include "train/wait_limit.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::multipleOf;
using cli::OptionRow;
using cli::row;
using cli::ValueType;

constexpr int kCrowd = int(train::CrowdSettings{}.levels * train::CrowdSettings{}.worlds);
constexpr const char* kLevelGroup = "Levels";
constexpr const char* kLearnGroup = "Learning";
constexpr const char* kKeepGroup = "Keeping and going on";
constexpr const char* kLogGroup = "Looking on";
constexpr const char* kEvaluateGroup = "Evaluating";

OptionRow outputRow() {
  OptionRow r = cli::commonRow(cli::Common::output);
  r.defaultText = "policy.obp";
  r.help = "write the policy to FILE, now and then and in the end";
  return r;
}

OptionRow timeLimitRow() {
  OptionRow r = cli::commonRow(cli::Common::timeLimit);
  r.help =
      "stop after so much wall-clock time, whatever --decisions or --eval-levels says; a stream "
      "that sends nothing is waited for 3 seconds longer";
  r.group = kLearnGroup;
  return r;
}

OptionRow backendRow() {
  OptionRow r = cli::commonRow(cli::Common::backend);
  r.help =
      "where worlds play and the policy learns; auto takes a GPU where there is one. Networks "
      "learned here and there differ by rounding";
  r.group = kLearnGroup;
  return r;
}

// No records are passed on.
OptionRow onErrorRow() {
  OptionRow r = cli::commonRow(cli::Common::onError);
  r.choices = {"stop", "skip"};
  r.help =
      "a bad record of the stream: stop, or leave it out; the exit code is 2 in either case; skip "
      "also takes what came of a stream that was interrupted for all there is";
  r.group = kLevelGroup;
  return r;
}

std::vector<OptionRow> levelRows() {
  return {row("generate", ValueType::flag, "", "",
              "make the levels, always new ones, instead of reading a stream; --style, "
              "--difficulty and --recipe say this too",
              kLevelGroup),
          onErrorRow()};
}

template <class Number>
OptionRow learnRow(const char* name, ValueType type, const char* value, Number standard,
                   const char* help, double least, double most) {
  return between(row(name, type, value, fmt::format("{}", standard), help, kLearnGroup), least,
                 most);
}

std::vector<OptionRow> learnRows() {
  const train::TrainerSettings s;
  return {
      learnRow("decisions", ValueType::integer, "N", s.decisions,
               "decisions to learn from, 20 a second of play", 1, 9e15),
      timeLimitRow(),
      backendRow(),
      multipleOf(learnRow("worlds", ValueType::integer, "N", s.worlds(),
                          "worlds that play at a time; a multiple of 256", kCrowd, 1 << 20),
                 kCrowd),
      learnRow("rate", ValueType::number, "R", s.ppo.rate,
               "learning rate at first; falls to a tenth of it", 1e-7, 1),
      learnRow("passes", ValueType::integer, "N", s.ppo.passes,
               "passes over each batch of decisions", 1, 100),
      learnRow("part", ValueType::integer, "N", s.ppo.part,
               "decisions in each step of the optimiser, at most", 64, 1 << 20),
      learnRow("entropy", ValueType::number, "SHARE", s.ppo.loss.entropyShare,
               "share of entropy in the loss: how much trying things out is worth", 0, 10),
      learnRow("discount", ValueType::number, "SHARE", s.ppo.discount,
               "worth of a reward one decision later", 0, 1),
  };
}

OptionRow resumeRow() {
  OptionRow r = row("resume", ValueType::mode, "MODE", "no",
                    "go on from the checkpoint, with the options of then; =auto: begin anew where "
                    "there is none yet",
                    kKeepGroup);
  r.choices = {"no", "yes", "auto"};
  r.bare = "yes";
  return r;
}

std::vector<OptionRow> keepRows() {
  return {row("checkpoint", ValueType::file, "FILE", "",
              "keep in FILE what is needed to go on; otherwise beside the policy, with .checkpoint "
              "behind its name",
              kKeepGroup),
          resumeRow(),
          row("start-from", ValueType::file, "FILE", "",
              "begin with the policy of FILE instead of a fresh network, as to fine-tune it on "
              "levels of your own; with --resume it need not be named again",
              kKeepGroup),
          between(row("save-every", ValueType::number, "SECONDS", "60",
                      "between two writes of checkpoint and policy", kKeepGroup),
                  0, 1e6)};
}

std::vector<OptionRow> logRows() {
  return {
      row("log", ValueType::file, "FILE", "",
          "write metrics to FILE as comma-separated values; with --resume it goes on", kLogGroup),
      row("tensorboard", ValueType::file, "DIR", "",
          "write metrics into the folder DIR for TensorBoard", kLogGroup),
      between(row("log-every", ValueType::integer, "N", "10",
                  "iterations between two rows of --log and --tensorboard", kLogGroup),
              1, 1e9),
      row("curve", ValueType::file, "FILE", "",
          "draw success, difficulty and reward over decisions to FILE, an SVG; as often as "
          "--save-every says",
          kLogGroup)};
}

std::vector<OptionRow> evaluateRows() {
  return {
      row("eval", ValueType::file, "FILE", "",
          "learn nothing: let the policy of FILE play levels by itself, on the CPU, and say how "
          "many it solves",
          kEvaluateGroup),
      between(row("eval-levels", ValueType::integer, "N", "1000",
                  "levels to evaluate on; of a stream each once, at most so many", kEvaluateGroup),
              1, 1 << 24),
      between(row("eval-tries", ValueType::integer, "N", "8",
                  "playthroughs of each level: one of the likeliest moves, the others drawn",
                  kEvaluateGroup),
              1, 1 << 16),
  };
}

}  // namespace

Status optionsFit(const cli::Arguments& a) {
  if (makesLevels(a)) {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(
        a, {"on-error"}, "no stream is read where levels are made", "leave out one of the two"));
  }
  if (a.has("eval")) {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(
        a, {"backend"}, "levels are played on the CPU with --eval", "leave out one of the two"));
    return cli::refuseTyped(
        a,
        {"output", "resume", "checkpoint", "log", "tensorboard", "curve", "save-every", "log-every",
         "rate", "passes", "part", "entropy", "discount", "worlds", "decisions", "start-from"},
        "nothing is learned with --eval", "leave out one of the two");
  }
  OBBY_RETURN_IF_ERROR(cli::refuseTyped(a, {"eval-levels", "eval-tries"},
                                        "nothing is evaluated without --eval",
                                        "name the policy by --eval FILE, or leave it out"));
  if (a.has("log") || a.has("tensorboard")) return {};
  return cli::refuseTyped(a, {"log-every"}, "nothing is logged without --log or --tensorboard",
                          "leave it out");
}

cli::ToolSpec trainSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-train";
  spec.summary = "learn to play levels, for the search to be guided by";
  spec.examples = {
      {"learn from the levels of a stream",
       "obby-gen --count 60 --seed 7 | obby-train --time-limit 20 -o policy.obp"},
      {"learn a minute long from levels that are always new",
       "obby-train --generate --difficulty trivial..limit --time-limit 60 -o policy.obp"},
      {"go on with learning that was broken off, as if it had not been",
       "obby-train --style gaps --decisions 300000 --time-limit 1 && "
       "obby-train --style gaps --decisions 300000 --resume"},
      {"learn first on many levels, then go on with some of your own",
       "obby-train --style gaps --time-limit 5 && obby-gen --style course --count 20 | "
       "obby-train --start-from policy.obp --rate 0.0005 --time-limit 5 -o mine.obp"},
      {"look on, by a table, by TensorBoard and by a picture",
       "obby-train --style gaps --time-limit 2 --log learning.csv --tensorboard runs/gaps "
       "--curve learning.svg"},
      {"how good is it on levels that it has never seen?",
       "obby-train --style gaps --time-limit 5 && obby-train --eval policy.obp --style gaps "
       "--eval-levels 100"},
  };
  spec.readsInputs = [](const cli::Arguments& a) { return !makesLevels(a); };
  spec.alwaysToStandardOutput = true;  // the metrics
  spec.options = {outputRow(), cli::commonRow(cli::Common::progress),
                  cli::commonRow(cli::Common::threads), cli::commonRow(cli::Common::seed)};
  for (const auto& rows :
       {levelRows(), recipeRows(kLevelGroup), learnRows(), keepRows(), logRows(), evaluateRows()}) {
    spec.options.insert(spec.options.end(), rows.begin(), rows.end());
  }
  spec.notes =
      "Metrics go to standard output, a record each few seconds. The same seed, levels and number "
      "of --worlds give the same policy on this machine and backend, for any number of --threads. "
      "Levels that are made begin easy, and become harder up to --difficulty as the policy learns; "
      "so do those of a stream where its queries say how hard they are, as those of obby-gen "
      "do.\n\n"
      "Started by mpirun, the ranks learn one network together, each with --worlds of its own.";
  return spec;
}

train::TrainerSettings trainerSettings(const cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  train::TrainerSettings s;
  s.seed = a.seed();
  s.crowds = uint32_t(a.integer("worlds")) / (s.crowd.levels * s.crowd.worlds);
  s.decisions = uint64_t(a.integer("decisions"));
  s.ppo.rate = float(a.number("rate"));
  s.ppo.passes = uint32_t(a.integer("passes"));
  s.ppo.part = uint32_t(a.integer("part"));
  s.ppo.discount = float(a.number("discount"));
  s.ppo.loss.entropyShare = float(a.number("entropy"));
  return s;
}

Result<sim::Backend> trainBackend(const cli::Context& context, uint32_t which) {
  OBBY_ASSIGN(const sim::BackendKind kind, sim::backendKind(context.arguments().text("backend")));
  return sim::Backend::open(kind, which);
}

double timeLimit(const cli::Arguments& a) {
  return a.has("time-limit") ? a.number("time-limit") : train::WaitLimit::kNone;
}

train::EvaluationSettings evaluationSettings(const cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  train::EvaluationSettings s;
  s.seed = a.seed();
  s.levels = uint32_t(a.integer("eval-levels"));
  s.tries = uint32_t(a.integer("eval-tries"));
  s.seconds = timeLimit(a);
  return s;
}

}  // namespace obby::tools
