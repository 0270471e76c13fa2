// What each part of the policy's observation is worth: a policy learns without it, from the same
// levels for as many decisions, and then plays levels that none of them was trained on. Takes about
// a minute a row for each 30 million decisions.
//   bench_observation [--json] [--decisions N] [ROW...]
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "common/report.h"
#include "shared/generated_levels.h"
#include "train/evaluate.h"
#include "train/trainer.h"

namespace {

using namespace obby;

struct Range {
  int first, count;  // inputs
};

struct Row {
  const char* name;
  uint64_t seed;
  std::vector<Range> hidden;
};

constexpr int mapAt(int map) { return policy::kStateInputs + map * policy::kPoints; }

// A ring of all maps.
std::vector<Range> ring(int number) {
  std::vector<Range> out;
  for (int map = 0; map < policy::kMaps; ++map)
    out.push_back({mapAt(map) + 1 + number * policy::kDirections, policy::kDirections});
  return out;
}

// Inputs are numbered in lib/policy/observation.h.
std::vector<Row> rows() {
  return {
      {"all", 1, {}},
      {"allSeed2", 2, {}},
      {"allSeed3", 3, {}},
      {"noVelocity", 1, {{0, 3}}},
      {"noFloorAndState", 1, {{3, 9}}},
      {"noWayToRegion", 1, {{12, 6}}},
      {"noFacing", 1, {{18, 2}}},
      {"noLimits", 1, {{20, 2}}},
      {"noHealthAndPace", 1, {{22, 4}}},
      {"noFloorsNow", 1, {{mapAt(0), policy::kPoints}}},
      {"noFloorsSoon", 1, {{mapAt(2), policy::kPoints}}},
      {"noDangersNow", 1, {{mapAt(1), policy::kPoints}}},
      {"noDangersSoon", 1, {{mapAt(3), policy::kPoints}}},
      {"noMaps", 1, {{mapAt(0), policy::kMaps * policy::kPoints}}},
      {"noInnermostRing", 1, ring(0)},
      {"noOutermostRing", 1, ring(policy::kRings - 1)},
  };
}

int fail(const Error& error) {
  fmt::print(stderr, "bench_observation: {}\n", error.text());
  return 1;
}

Result<train::Evaluation> measure(const Row& row, uint64_t decisions, ThreadPool& pool) {
  gen::Recipe recipe;
  recipe.difficulty = {0, 1};
  OBBY_ASSIGN(const auto levels, tools::generatedLevels(recipe, row.seed));
  OBBY_ASSIGN(const auto unseen, tools::generatedLevels(recipe, 0x68656c64));
  train::TrainerSettings settings;
  settings.seed = row.seed;
  settings.decisions = decisions;
  for (const Range& range : row.hidden) {
    for (int i = 0; i < range.count; ++i) settings.hidden.push_back(range.first + i);
  }
  train::OneRank alone;
  OBBY_ASSIGN(const auto trainer, train::Trainer::make(settings, *levels, pool, alone));
  while (trainer->decisions() < decisions) {
    OBBY_ASSIGN(const auto iteration, trainer->iterate());
    (void)iteration;
  }
  return train::evaluate(trainer->network(), *unseen, {}, pool, false);
}

}  // namespace

int main(int argc, char** argv) {
  uint64_t decisions = 30'000'000;
  bench::Report::Form form = bench::Report::Form::table;
  std::vector<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    if (!strcmp(argv[i], "--json")) {
      form = bench::Report::Form::json;
    } else if (!strcmp(argv[i], "--decisions") && i + 1 < argc) {
      decisions = std::strtoull(argv[++i], nullptr, 10);
    } else {
      wanted.push_back(argv[i]);
    }
  }
  for (const std::string& name : wanted) {
    const std::vector<Row> all = rows();
    if (std::any_of(all.begin(), all.end(), [&](const Row& row) { return row.name == name; }))
      continue;
    fmt::print(stderr, "bench_observation: no case '{}'\n", name);
    return 2;
  }
  bench::Report report("observation", form);
  ThreadPool pool(availableThreads());
  for (const Row& row : rows()) {
    if (!wanted.empty() && std::count(wanted.begin(), wanted.end(), row.name) == 0) continue;
    const auto result = measure(row, decisions, pool);
    if (!result) return fail(result.error());
    report.add(row.name, "solvedLikeliest", result->likeliest, "");
    report.add(row.name, "solvedDrawn", result->drawn, "");
    report.add(row.name, "solvedAny", result->any, "");
  }
}
