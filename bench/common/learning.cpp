#include "common/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>

#include "common/report.h"
#include "io/read_file.h"
#include "shared/generated_levels.h"
#include "train/evaluate.h"

namespace obby::bench {

namespace {

constexpr uint64_t kUnseen = 0x68656c64;  // seed of the levels not used in training

struct Asked {
  uint64_t decisions = 30'000'000, seeds = 3;
  Report::Form form = Report::Form::table;
  const char* recipe = nullptr;
  std::vector<std::string> rows;  // empty: all
};

Asked read(int argc, char** argv) {
  Asked asked;
  for (int i = 1; i < argc; ++i) {
    const auto is = [&](const char* name) { return !std::strcmp(argv[i], name) && i + 1 < argc; };
    if (!std::strcmp(argv[i], "--json")) {
      asked.form = Report::Form::json;
    } else if (is("--decisions")) {
      asked.decisions = std::strtoull(argv[++i], nullptr, 10);
    } else if (is("--seeds")) {
      asked.seeds = std::max<uint64_t>(std::strtoull(argv[++i], nullptr, 10), 1);
    } else if (is("--recipe")) {
      asked.recipe = argv[++i];
    } else {
      asked.rows.push_back(argv[i]);
    }
  }
  return asked;
}

Result<gen::Recipe> recipeOf(const Asked& asked) {
  if (asked.recipe) {
    OBBY_ASSIGN(const std::string text, io::readFile(asked.recipe));
    return gen::Recipe::fromJson(text);
  }
  gen::Recipe all;
  all.difficulty = {0, 1};
  return all;
}

Result<train::Evaluation> measure(const LearningRow& row, const gen::Recipe& recipe, uint64_t seed,
                                  uint64_t decisions, ThreadPool& pool) {
  OBBY_ASSIGN(const auto levels, tools::generatedLevels(recipe, seed));
  OBBY_ASSIGN(const auto unseen, tools::generatedLevels(recipe, kUnseen));
  train::TrainerSettings settings;
  settings.seed = seed;
  settings.decisions = decisions;
  row.change(settings);
  train::OneRank alone;
  OBBY_ASSIGN(const auto trainer, train::Trainer::make(settings, *levels, pool, alone));
  while (trainer->decisions() < decisions) {
    OBBY_ASSIGN(const auto iteration, trainer->iterate());
    (void)iteration;
  }
  train::EvaluationSettings how;
  how.observe = settings.envGroup.observe;
  train::Evaluation found = train::evaluate(trainer->network(), *unseen, how, pool, false);
  OBBY_RETURN_IF_ERROR(std::move(found.missing));
  return found;
}

// Reports the mean, minimum and maximum over the seeds.
void add(Report& report, const LearningRow& row, const char* metric, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  report.add(row.name, metric, sum / double(values.size()), "");
  report.add(row.name, fmt::format("{}Min", metric), values.front(), "");
  report.add(row.name, fmt::format("{}Max", metric), values.back(), "");
}

Status reportRow(Report& report, const LearningRow& row, const gen::Recipe& recipe,
                 const Asked& asked, ThreadPool& pool) {
  std::vector<double> likeliest, drawn, any;
  for (uint64_t seed = 1; seed <= asked.seeds; ++seed) {
    OBBY_ASSIGN(const auto result, measure(row, recipe, seed, asked.decisions, pool));
    likeliest.push_back(result.likeliest);
    drawn.push_back(result.drawn);
    any.push_back(result.any);
  }
  add(report, row, "solvedLikeliest", likeliest);
  add(report, row, "solvedDrawn", drawn);
  add(report, row, "solvedAny", any);
  return {};
}

Status reportAll(const char* bench, const std::vector<LearningRow>& rows, const Asked& asked) {
  OBBY_ASSIGN(const gen::Recipe recipe, recipeOf(asked));
  Report lines(bench, asked.form);
  ThreadPool pool(availableThreads());
  for (const LearningRow& row : rows) {
    if (!asked.rows.empty() && !std::count(asked.rows.begin(), asked.rows.end(), row.name))
      continue;
    OBBY_RETURN_IF_ERROR(reportRow(lines, row, recipe, asked, pool));
  }
  return {};
}

bool has(const std::vector<LearningRow>& rows, const std::string& name) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const LearningRow& r) { return r.name == name; });
}

}  // namespace

int learningBench(int argc, char** argv, const char* bench, const std::vector<LearningRow>& rows) {
  const Asked asked = read(argc, argv);
  for (const std::string& name : asked.rows) {
    if (has(rows, name)) continue;
    fmt::print(stderr, "bench_{}: no case '{}'\n", bench, name);
    return 2;
  }
  const Status said = reportAll(bench, rows, asked);
  if (said) return 0;
  fmt::print(stderr, "bench_{}: {}\n", bench, said.error().text());
  return 1;
}

}  // namespace obby::bench
