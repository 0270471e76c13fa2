// Measures the difficulty of generated levels by style (docs/generator.md): the share that `auto`
// solves with the shipped policy, its median steps, and the share of unsolvable twins proven
// unreachable. All but the times are the same on every machine.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/thread_pool.h"
#include "common/need.h"
#include "common/report.h"
#include "gen/generator.h"
#include "gen/styles.h"
#include "policy/shipped_policy.h"
#include "solve/methods.h"
#include "solve/query_solver.h"

namespace {

using namespace obby;
using bench::need;

constexpr uint64_t kLevels = 40, kLevelSeed = 5, kSearchSeed = 1;

struct Difficulty {
  const char* name;
  float value;
  uint64_t steps;  // max steps for each level
};
constexpr Difficulty kDifficulties[] = {{"Trivial", 0, 1'000'000},
                                        {"Easy", 0.25f, 1'000'000},
                                        {"Medium", 0.5f, 1'000'000},
                                        {"Hard", 0.75f, 1'000'000},
                                        {"Limit", 1, 3'000'000}};

gen::Generator generatorOf(const char* style, float difficulty, bool unsolvable) {
  gen::Recipe recipe;
  recipe.styles = {{style, 1}};
  recipe.difficulty = {difficulty, difficulty};
  return need(gen::Generator::make(recipe, unsolvable));
}

struct Answer {
  schema::Verdict verdict = schema::Verdict::UNKNOWN;
  uint64_t steps = 0;
};

Answer ask(const gen::Generator& generator, uint64_t index, uint64_t steps) {
  const gen::Generated from = generator.generate(kLevelSeed, index);
  io::RecordBuilder level, query;
  generator.writeLevel(from, level.root().initLevel());
  gen::Generator::writeQuery(from, query.root().initQuery());
  const solve::LoadedLevel loaded = need(solve::loadLevel(io::Record(std::move(level))));
  solve::SolverOptions options;
  options.method = solve::findMethod("auto");
  options.policy = &policy::shippedPolicy().network;
  options.progressRecords = false;
  options.budget.seed = kSearchSeed;
  options.budget.maxSteps = steps;
  options.budget.attempts = 0;
  Answer answer;
  solve::SolverOutput output;
  output.write = [&answer](schema::Record::Reader record) -> Status {
    if (record.isResult())
      answer = {record.getResult().getVerdict(), record.getResult().getSteps()};
    return {};
  };
  ThreadPool alone(1);
  (void)need(solve::solveQuery(loaded, query.reader().getQuery(), options, {alone}, output));
  return answer;
}

// Answers all levels of the generator in parallel.
std::vector<Answer> askAll(const gen::Generator& generator, uint64_t steps, ThreadPool& pool) {
  std::vector<Answer> answers(kLevels);
  pool.run(int(kLevels), [&](int i) { answers[size_t(i)] = ask(generator, uint64_t(i), steps); });
  return answers;
}

double shareOf(const std::vector<Answer>& answers, schema::Verdict verdict) {
  return double(std::count_if(answers.begin(), answers.end(),
                              [&](const Answer& a) { return a.verdict == verdict; })) /
         double(answers.size());
}

// Returns the median over the solved levels, or 0 if none was solved.
double medianSteps(const std::vector<Answer>& answers) {
  std::vector<uint64_t> steps;
  for (const Answer& a : answers) {
    if (a.verdict == schema::Verdict::SOLVED) steps.push_back(a.steps);
  }
  if (steps.empty()) return 0;
  std::sort(steps.begin(), steps.end());
  return (double(steps[(steps.size() - 1) / 2]) + double(steps[steps.size() / 2])) / 2;
}

}  // namespace

int main(int argc, char** argv) {
  bench::Report report(argc, argv, "styles");
  ThreadPool pool(availableThreads());
  for (const gen::Style& style : gen::styles()) {
    for (const Difficulty& d : kDifficulties) {
      const auto answers = askAll(generatorOf(style.name, d.value, false), d.steps, pool);
      report.add(style.name, fmt::format("solved{}", d.name),
                 shareOf(answers, schema::Verdict::SOLVED), "");
      report.add(style.name, fmt::format("steps{}", d.name), medianSteps(answers), "");
    }
    const auto twins = askAll(generatorOf(style.name, 0.25f, true), 1, pool);
    report.add(style.name, "provedTwins", shareOf(twins, schema::Verdict::UNREACHABLE), "");
  }
}
