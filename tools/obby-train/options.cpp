// The option table of obby-train and what its options mean to lib/train.
#include "options.h"

#include <fmt/format.h>

#include "cli/command_text.h"
#include "cli/rows.h"
#include "cli/written_files.h"
#include "levels.h"
#include "shared/recipe_options.h"
#include "train/timeout.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::multipleOf;
using cli::OptionRow;
using cli::rare;
using cli::renamed;
using cli::row;
using cli::ValueType;

constexpr int kEnvGroup = int(train::EnvGroupSettings{}.levels * train::EnvGroupSettings{}.worlds);
constexpr const char* kLevelGroup = "Levels to train on";
constexpr const char* kDifficulty = "the recipe's, or trivial..limit without --recipe";
constexpr const char* kLearnGroup = "Training";
constexpr const char* kKeepGroup = "Checkpoints";
constexpr const char* kLogGroup = "Logs";
constexpr const char* kEvaluateGroup = "Evaluation (nothing is trained)";

OptionRow common(cli::Common option, const char* help, const char* details) {
  OptionRow r = cli::commonRow(option);
  r.help = help;
  r.details = details;
  return r;
}

OptionRow outputRow() {
  return cli::withDefault(
      common(cli::Common::output, "write the policy to FILE, during training and at its end", ""),
      "policy.obp");
}

// No records are passed on, so there is no "emit".
OptionRow onErrorRow() {
  OptionRow r = common(
      cli::Common::onError, "on a bad record: stop, or skip it; the exit code is 2 either way",
      "skip also trains on the part of a stream that arrived before it was interrupted.");
  r.choices = {"stop", "skip"};
  return rare(r);
}

std::vector<OptionRow> levelRows() {
  return {row("generate", ValueType::flag, "", "",
              "train on freshly generated levels, not on a stream; --style, --difficulty and "
              "--recipe imply it",
              kLevelGroup)};
}

template <class Number>
OptionRow learnRow(const char* name, ValueType type, const char* value, Number standard,
                   const char* help, double min, double max) {
  return between(row(name, type, value, fmt::format("{}", standard), help, kLearnGroup), min, max);
}

std::vector<OptionRow> learnRows() {
  const train::TrainerSettings s;
  return {
      learnRow("decisions", ValueType::integer, "N", s.decisions,
               "decisions to learn from, 20 per second of play", 1, 9e15),
      common(cli::Common::timeLimit,
             "stop after this wall-clock time, regardless of --decisions or --eval-levels",
             "If the stream sends nothing, obby-train waits for it 3 seconds longer."),
      row("start-from", ValueType::file, "FILE", "",
          "start from this policy instead of a new network, for example to fine-tune it on your "
          "own levels",
          kLearnGroup),
      common(cli::Common::backend,
             "device for simulation and learning; auto uses a GPU if there is one",
             "Policies trained on a GPU and on the CPU differ by rounding."),
      cli::commonRow(cli::Common::threads),
      common(cli::Common::seed,
             "random seed: same seed, same results unless a time limit ends the run", ""),
      rare(multipleOf(
          learnRow("worlds", ValueType::integer, "N", s.worlds(),
                   "worlds that play at the same time; a multiple of 256", kEnvGroup, 1 << 20),
          kEnvGroup)),
      rare(renamed(learnRow("learning-rate", ValueType::number, "R", s.ppo.learningRate,
                            "initial learning rate; it falls to a tenth of this", 1e-7, 1),
                   "rate")),
      rare(renamed(learnRow("epochs", ValueType::integer, "N", s.ppo.epochs,
                            "passes over each batch of decisions", 1, 100),
                   "passes")),
      rare(renamed(learnRow("minibatch", ValueType::integer, "N", s.ppo.minibatch,
                            "maximum size of a minibatch, in decisions", 64, 1 << 20),
                   "part")),
      rare(learnRow("entropy", ValueType::number, "SHARE", s.ppo.loss.entropyWeight,
                    "weight of the entropy in the loss; higher values make the policy explore more",
                    0, 10)),
      rare(learnRow("discount", ValueType::number, "SHARE", s.ppo.discount,
                    "discount factor of the reward per decision", 0, 1)),
  };
}

OptionRow resumeRow() {
  OptionRow r = row("resume", ValueType::mode, "MODE", "no",
                    "resume from the checkpoint; =auto: start a new run if there is none; give the "
                    "same levels and options, except --threads and --time-limit",
                    kKeepGroup);
  r.details =
      "--on-error and the options that name output files may differ, too. --start-from need not be "
      "repeated.";
  r.choices = {"no", "yes", "auto"};
  r.bare = "yes";
  return r;
}

std::vector<OptionRow> keepRows() {
  return {resumeRow(),
          row("checkpoint", ValueType::file, "FILE", "",
              "keep the state of training in FILE [default: the policy's name with .checkpoint "
              "appended]",
              kKeepGroup),
          rare(between(row("save-every", ValueType::number, "SECONDS", "60",
                           "time between saves of the checkpoint and the policy", kKeepGroup),
                       0, 1e6))};
}

std::vector<OptionRow> logRows() {
  return {row("tensorboard", ValueType::file, "DIR", "",
              "write metrics to the folder DIR for TensorBoard", kLogGroup),
          rare(between(row("log-every", ValueType::integer, "N", "10",
                           "iterations between two points of --tensorboard", kLogGroup),
                       1, 1e9))};
}

std::vector<OptionRow> evaluateRows() {
  return {
      row("eval", ValueType::file, "FILE", "",
          "let the policy in FILE play levels by itself, on the CPU, and report how many it solves",
          kEvaluateGroup),
      between(
          row("eval-levels", ValueType::integer, "N", "1000",
              "number of levels to play; from a stream, each level is used once, up to this number",
              kEvaluateGroup),
          1, 1 << 24),
      rare(between(
          row("eval-tries", ValueType::integer, "N", "8",
              "attempts at each level: one takes the most probable actions, the others sample",
              kEvaluateGroup),
          1, 1 << 16)),
  };
}

std::vector<cli::Example> examples() {
  return {
      {"Train on levels from a stream",
       "obby-gen --count 60 --seed 7 | obby-train --time-limit 20"},
      {"Train on freshly generated levels of one style",
       "obby-train --style gaps --time-limit 20 -o gaps.obp"},
      {"Resume interrupted training exactly where it stopped",
       "obby-train --style gaps --decisions 300000 --time-limit 1 && "
       "obby-train --style gaps --decisions 300000 --resume"},
      {"Evaluate a policy on levels that it has never seen",
       "obby-train --style gaps --time-limit 5 && "
       "obby-train --eval policy.obp --style gaps --eval-levels 100"},
      {"Train on generated levels, then fine-tune on your own",
       "obby-train --style gaps --time-limit 5 && obby-gen --style course --count 20 | "
       "obby-train --start-from policy.obp --learning-rate 0.0005 --time-limit 5 -o mine.obp"},
      {"Log to TensorBoard", "obby-train --style gaps --time-limit 5 --tensorboard runs/gaps"},
  };
}

}  // namespace

Status optionsFit(const cli::Arguments& a) {
  constexpr const char* kOneOfTwo = "leave out one of the two";
  if (makesLevels(a)) {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(
        a, {"on-error"}, "has no effect on generated levels, because no stream is read",
        "leave out --on-error"));
  }
  if (a.has("eval")) {
    OBBY_RETURN_IF_ERROR(cli::refuseTyped(
        a, {"backend"}, "cannot be combined with --eval, which plays on the CPU", kOneOfTwo));
    return cli::refuseTyped(a,
                            {"output", "resume", "checkpoint", "tensorboard", "save-every",
                             "log-every", "learning-rate", "epochs", "minibatch", "entropy",
                             "discount", "worlds", "decisions", "start-from"},
                            "cannot be combined with --eval, which trains nothing", kOneOfTwo);
  }
  OBBY_RETURN_IF_ERROR(
      cli::refuseTyped(a, {"eval-levels", "eval-tries"}, "has no effect without --eval",
                       "name a policy with --eval FILE, or leave out this option"));
  if (a.has("tensorboard")) return {};
  return cli::refuseTyped(a, {"log-every"}, "has no effect without --tensorboard",
                          "add --tensorboard, or leave out --log-every");
}

Status filesFit(const cli::Arguments& a) {
  const cli::WrittenFile metrics{"", "-"};
  if (a.has("eval")) return cli::refuseOverwriting(a, {&metrics, 1});
  const auto wrong = [](const std::string& option, const char* message) {
    return Error{{}, {}, "--" + option, message, "name a file"};
  };
  if (a.text("output").empty()) return wrong("output", "the file name is empty");
  for (const char* name : {"output", "checkpoint"}) {
    if (a.text(name) == "-")
      return wrong(name, "cannot be standard output, which receives the metrics");
  }
  const train::RunFiles files = runFiles(a);
  const cli::WrittenFile written[] = {
      metrics, {"output", files.policy}, {"checkpoint", files.checkpoint}};
  return cli::refuseOverwriting(a, written);
}

std::vector<std::string> rankOptions(const cli::Arguments& a) {
  // Leaves out --threads, which may differ by machine and does not change the result; --config,
  // whose contents are compared; and options about messages.
  return cli::optionTexts(
      a, {"threads", "config", "progress", "quiet", "verbose", "no-color", "json-errors"});
}

cli::ToolSpec trainSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-train";
  spec.summary = "train a policy that plays levels and guides the search";
  spec.inputHelp = "streams with levels and queries";
  spec.examples = examples();
  spec.readsInputs = [](const cli::Arguments& a) { return !makesLevels(a); };
  spec.alwaysToStandardOutput = true;  // the metrics
  spec.options = cli::joined({{outputRow(), onErrorRow(), cli::commonRow(cli::Common::progress)},
                              levelRows(),
                              recipeRows(kLevelGroup, kDifficulty),
                              learnRows(),
                              keepRows(),
                              logRows(),
                              evaluateRows()});
  for (OptionRow& r : spec.options)
    if (r.group == cli::kRunGroup) r.group = kLearnGroup;
  spec.notes =
      "Metrics go to standard output, as a record every few seconds. Generated levels begin easy "
      "and get harder, up to --difficulty, as the policy improves. Levels from a stream are also "
      "ordered from easy to hard if their queries state a difficulty, as obby-gen's do.";
  spec.details =
      "The same seed, levels and --worlds give the same policy on one machine and backend, for any "
      "number of --threads.\n\n"
      "The processes that mpirun starts train one network together, each simulating its own "
      "--worlds worlds.";
  spec.files = {
      {"policy.obp", "The policy, unless --output names another file."},
      {"policy.obp.checkpoint", "The state of training, unless --checkpoint names another file."}};
  return spec;
}

train::TrainerSettings trainerSettings(const cli::Arguments& a) {
  train::TrainerSettings s;
  s.seed = a.seed();
  s.envGroups = uint32_t(a.integer("worlds")) / (s.envGroup.levels * s.envGroup.worlds);
  s.decisions = uint64_t(a.integer("decisions"));
  s.ppo.learningRate = float(a.number("learning-rate"));
  s.ppo.epochs = uint32_t(a.integer("epochs"));
  s.ppo.minibatch = uint32_t(a.integer("minibatch"));
  s.ppo.discount = float(a.number("discount"));
  s.ppo.loss.entropyWeight = float(a.number("entropy"));
  return s;
}

Result<sim::Backend> trainBackend(const cli::Context& context, uint32_t which) {
  OBBY_ASSIGN(const sim::BackendKind kind, sim::backendKind(context.arguments().text("backend")));
  return sim::Backend::open(kind, which);
}

double timeLimit(const cli::Arguments& a) {
  return a.has("time-limit") ? a.number("time-limit") : train::Timeout::kNone;
}

train::RunFiles runFiles(const cli::Arguments& a) {
  const std::string &output = a.text("output"), &resume = a.text("resume");
  return {output, a.has("checkpoint") ? a.text("checkpoint") : train::defaultCheckpoint(output),
          a.text("start-from"),
          resume == "no"    ? train::Resume::no
          : resume == "yes" ? train::Resume::yes
                            : train::Resume::automatic};
}

train::RunIdentity runIdentity(const cli::Context& context) {
  return {cli::commandText("obby-train", context.arguments(), {"resume"}), context.identity()};
}

train::RunPlan runPlan(const cli::Context& context) {
  const cli::Arguments& a = context.arguments();
  return {{uint64_t(a.integer("decisions")), timeLimit(a), a.number("save-every"),
           uint64_t(a.integer("log-every"))},
          a.text("tensorboard"),
          context.identity()};
}

train::EvaluationSettings evaluationSettings(const cli::Arguments& a) {
  train::EvaluationSettings s;
  s.seed = a.seed();
  s.levels = uint32_t(a.integer("eval-levels"));
  s.tries = uint32_t(a.integer("eval-tries"));
  s.seconds = timeLimit(a);
  return s;
}

}  // namespace obby::tools
