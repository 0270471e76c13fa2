// What each part of the policy's observation is worth: a policy learns without it, from the same
// levels for as many decisions, and then plays levels that none of them was trained on. The mean of
// some seeds, with the least and the most. Takes about a minute a row and seed for each 30 million
// decisions.
//   bench_observation [--json] [--decisions N] [--seeds N] [ROW...]
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>

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
  std::vector<Range> hidden;
};

constexpr int mapAt(int map) { return policy::kMapsAt + map * policy::kPoints; }

// A ring of all maps.
std::vector<Range> ring(int number) {
  std::vector<Range> out;
  for (int map = 0; map < policy::kMaps; ++map)
    out.push_back({mapAt(map) + 1 + number * policy::kDirections, policy::kDirections});
  return out;
}

// Every other direction of all maps.
std::vector<Range> halfOfDirections() {
  std::vector<Range> out;
  for (int map = 0; map < policy::kMaps; ++map) {
    for (int i = 1; i < policy::kDirections * policy::kRings; i += 2)
      out.push_back({mapAt(map) + 1 + i, 1});
  }
  return out;
}

// Inputs are numbered in lib/policy/observation.h.
std::vector<Row> rows() {
  const Range floors{mapAt(0), policy::kPoints}, dangers{mapAt(1), policy::kPoints};
  const Range floorsSoon{mapAt(2), policy::kPoints}, dangersSoon{mapAt(3), policy::kPoints};
  return {
      {"all", {}},
      {"noVelocity", {{0, 3}}},
      {"noFloorAndState", {{3, 9}}},
      {"noWayToRegion", {{12, 6}}},
      {"noFacing", {{18, 2}}},
      {"noLimits", {{20, 2}}},
      {"noHealthAndPace", {{22, 4}}},
      {"noLooseBody", {{policy::kStateInputs, policy::kLooseInputs}}},
      {"noFloorsNow", {floors}},
      {"noFloorsSoon", {floorsSoon}},
      {"noDangersNow", {dangers}},
      {"noDangersSoon", {dangersSoon}},
      {"noSoon", {floorsSoon, dangersSoon}},
      {"noDangers", {dangers, dangersSoon}},
      {"noMaps", {{mapAt(0), policy::kMaps * policy::kPoints}}},
      {"noInnermostRing", ring(0)},
      {"noOutermostRing", ring(policy::kRings - 1)},
      {"halfOfDirections", halfOfDirections()},
  };
}

int fail(const Error& error) {
  fmt::print(stderr, "bench_observation: {}\n", error.text());
  return 1;
}

Result<train::Evaluation> measure(const Row& row, uint64_t seed, uint64_t decisions,
                                  ThreadPool& pool) {
  gen::Recipe recipe;
  recipe.difficulty = {0, 1};
  OBBY_ASSIGN(const auto levels, tools::generatedLevels(recipe, seed));
  OBBY_ASSIGN(const auto unseen, tools::generatedLevels(recipe, 0x68656c64));
  train::TrainerSettings settings;
  settings.seed = seed;
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
  train::Evaluation found = train::evaluate(trainer->network(), *unseen, {}, pool, false);
  OBBY_RETURN_IF_ERROR(std::move(found.missing));
  return found;
}

// Mean, least and most of the seeds.
void add(bench::Report& report, const Row& row, const char* metric, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  report.add(row.name, metric, sum / double(values.size()), "");
  report.add(row.name, fmt::format("{}Least", metric), values.front(), "");
  report.add(row.name, fmt::format("{}Most", metric), values.back(), "");
}

}  // namespace

int main(int argc, char** argv) {
  uint64_t decisions = 30'000'000, seeds = 3;
  bench::Report::Form form = bench::Report::Form::table;
  std::vector<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    if (!strcmp(argv[i], "--json")) {
      form = bench::Report::Form::json;
    } else if (!strcmp(argv[i], "--decisions") && i + 1 < argc) {
      decisions = std::strtoull(argv[++i], nullptr, 10);
    } else if (!strcmp(argv[i], "--seeds") && i + 1 < argc) {
      seeds = std::max<uint64_t>(std::strtoull(argv[++i], nullptr, 10), 1);
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
    std::vector<double> likeliest, drawn, any;
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto result = measure(row, seed, decisions, pool);
      if (!result) return fail(result.error());
      likeliest.push_back(result->likeliest);
      drawn.push_back(result->drawn);
      any.push_back(result->any);
    }
    add(report, row, "solvedLikeliest", likeliest);
    add(report, row, "solvedDrawn", drawn);
    add(report, row, "solvedAny", any);
  }
}
