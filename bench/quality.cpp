// Measures how good solutions are: time, jumps, turns back, key changes and path length of the
// suite's solutions, relative to the best known ones (bench/results/best-known.tsv), and the time
// to the first and the final solution.
//   bench_quality [--json] [--seconds S] [--prefer P] [--record] [--each] [FILE:ID ...]
//     --seconds S   improve each query for S seconds [default: 0.2]
//     --prefer P    only this preference; "first" does not improve [default: all]
//     --record      enter better values into the table of the best known
//     --each        also print each query's ticks, jumps, turns back and key changes, each next to
//                   the best known
// If OMPL is installed, the rows `sst` compare with its planner SST on every third query, under the
// simulated ticks that `natural` spends on it, and `sst4` under four times as many, on every 60th.
// The rows `natural/sst`, `fast/sst` and so on are the other methods on the queries that SST
// solves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "common/report.h"
#include "quality/best_known.h"
#include "quality/measure.h"
#include "suite/suite.h"
#ifdef OBBY_HAS_OMPL
#include "level/player.h"
#include "quality/measure_sst.h"
#endif

namespace {

using namespace obby;
using namespace obby::bench;

struct Options {
  bool json = false, record = false, each = false;
  double seconds = 0.2;
  std::string prefer;  // empty for all
  std::vector<std::string> only;
};

Options optionsOf(int argc, char** argv) {
  Options o;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const bool hasValue = i + 1 < argc;
    if (argument == "--json") {
      o.json = true;
    } else if (argument == "--record") {
      o.record = true;
    } else if (argument == "--each") {
      o.each = true;
    } else if (argument == "--seconds" && hasValue) {
      o.seconds = std::strtod(argv[++i], nullptr);
    } else if (argument == "--prefer" && hasValue) {
      o.prefer = argv[++i];
    } else if (!argument.starts_with('-')) {
      o.only.emplace_back(argument);
    } else {
      fmt::print(stderr,
                 "usage: bench_quality [--json] [--seconds S] [--prefer P] [--record] [--each] "
                 "[FILE:ID ...]\n");
      std::exit(2);
    }
  }
  return o;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, size_t(share * double(values.size())))];
}

double sumOf(const std::vector<Quality>& all, double Quality::*field) {
  double sum = 0;
  for (const Quality& q : all) sum += q.*field;
  return sum;
}

// The solutions of one method.
struct Row {
  std::string method;
  size_t asked = 0;                // queries
  std::vector<Quality> all;        // of the queries that it solves
  std::vector<std::string> names;  // parallel to `all`

  void add(const SuiteQuery& query, const std::optional<Quality>& quality, BestKnown& known) {
    ++asked;
    if (!quality) return;  // unsolved within the budget
    known.note(query.name(), *quality);
    all.push_back(*quality);
    names.push_back(query.name());
  }
  const Quality* of(const std::string& query) const {
    const auto at = std::ranges::find(names, query);
    return at == names.end() ? nullptr : &all[size_t(at - names.begin())];
  }
};

void reportRow(Report& report, const Row& row, const BestKnown& known) {
  const std::string& name = row.method;
  const std::vector<Quality>& all = row.all;
  std::vector<Quality> best;
  for (const std::string& query : row.names) best.push_back(known.of(query));
  std::vector<double> times, lengths, firsts, finals;
  for (size_t i = 0; i < all.size(); ++i) {
    times.push_back(all[i].ticks / best[i].ticks);
    if (best[i].length > 0) lengths.push_back(all[i].length / best[i].length);
    firsts.push_back(all[i].firstSeconds * 1000);
    finals.push_back(all[i].finalSeconds * 1000);
  }
  const auto total = [&](double Quality::*field) {
    return sumOf(all, field) / std::max(1.0, sumOf(best, field));
  };
  report.add(name, "asked", double(row.asked), "");
  report.add(name, "queries", double(all.size()), "");
  report.add(name, "timeRatioMedian", quantile(times, 0.5), "");
  report.add(name, "timeRatio90", quantile(times, 0.9), "");
  report.add(name, "timeRatioMax", quantile(times, 1), "");
  report.add(name, "lengthRatioMedian", quantile(lengths, 0.5), "");
  report.add(name, "jumps", sumOf(all, &Quality::jumps), "");
  report.add(name, "jumpRatio", total(&Quality::jumps), "");
  report.add(name, "turnsBack", sumOf(all, &Quality::turnsBack), "");
  report.add(name, "turnBackRatio", total(&Quality::turnsBack), "");
  report.add(name, "keyChanges", sumOf(all, &Quality::changes), "");
  report.add(name, "keyChangeRatio", total(&Quality::changes), "");
  report.add(name, "firstMedian", quantile(firsts, 0.5), "ms");
  report.add(name, "finalMedian", quantile(finals, 0.5), "ms");
  report.add(name, "final90", quantile(finals, 0.9), "ms");
}

void printEach(const Row& row, const BestKnown& known) {
  for (size_t i = 0; i < row.all.size(); ++i) {
    const Quality &q = row.all[i], best = known.of(row.names[i]);
    fmt::print("{:<12} {:<44} {:>5}/{:<5} {:>3}/{:<3} {:>3}/{:<3} {:>4}/{}\n", row.method,
               row.names[i], q.ticks, best.ticks, q.jumps, best.jumps, q.turnsBack, best.turnsBack,
               q.changes, best.changes);
  }
}

std::vector<Row> preferenceRows(const std::vector<SuiteQuery>& suite, const Options& options,
                                BestKnown& known) {
  ThreadPool pool(1);
  std::vector<const solve::Preference*> preferences{nullptr};
  for (const solve::Preference& p : solve::preferences()) preferences.push_back(&p);
  std::vector<Row> rows;
  for (const solve::Preference* p : preferences) {
    const std::string name = p == nullptr ? "first" : p->name;
    if (!options.prefer.empty() && name != options.prefer) continue;
    Row& row = rows.emplace_back();
    row.method = name;
    for (const SuiteQuery& q : suite) row.add(q, measure(q, p, options.seconds, pool), known);
  }
  return rows;
}

#ifdef OBBY_HAS_OMPL

// SST's time grows with the square of the budget. So it plans one in so many queries, and one in
// more with the longer budget, too.
constexpr size_t kEvery = 3, kLongEvery = 60;
constexpr uint64_t kLonger = 4;

// Returns a row followed by those of `natural` and `fast` on the queries that it solves.
std::vector<Row> compared(const Row& row, const Row& natural, const Row& fast) {
  std::vector<Row> rows{row};
  for (const Row* other : {&natural, &fast}) {
    Row& same = rows.emplace_back();
    same.method = other->method + "/" + row.method;
    for (const std::string& name : row.names) {
      const Quality* const quality = other->of(name);
      ++same.asked;
      if (quality == nullptr) continue;
      same.all.push_back(*quality);
      same.names.push_back(name);
    }
  }
  return rows;
}

// SST has the ticks that `natural` has spent on the query. It skips queries that name players.
std::vector<Row> sstRows(const std::vector<SuiteQuery>& suite, const Row& natural, const Row& fast,
                         BestKnown& known) {
  Row once{"sst", 0, {}, {}}, longer{"sst4", 0, {}, {}};
  for (size_t i = 0; i < suite.size(); i += kEvery) {
    const Quality* const reference = natural.of(suite[i].name());
    if (reference == nullptr || level::namesPlayers(suite[i].query.reader().getQuery())) continue;
    std::vector<uint64_t> budgets{reference->steps};
    if (i % kLongEvery == 0) budgets.push_back(reference->steps * kLonger);
    const auto found = measureSst(suite[i], budgets, {});
    once.add(suite[i], found.front(), known);
    if (found.size() > 1) longer.add(suite[i], found.back(), known);
  }
  std::vector<Row> rows = compared(once, natural, fast);
  std::ranges::move(compared(longer, natural, fast), std::back_inserter(rows));
  return rows;
}

#else

std::vector<Row> sstRows(const std::vector<SuiteQuery>&, const Row&, const Row&, BestKnown&) {
  fmt::print(stderr,
             "bench_quality: built without OMPL (scripts/setup reference); the comparison with its "
             "planner SST is left out\n");
  return {};
}

#endif

int run(const Options& options) {
  const std::string levels = OBBY_SOURCE_DIR "/levels";
  const std::string table = OBBY_SOURCE_DIR "/bench/results/best-known.tsv";
  auto suite = loadSuite(levels, options.only);
  auto known = BestKnown::read(table);
  if (!suite || !known) {
    fmt::print(stderr, "bench_quality: {}\n", (!suite ? suite.error() : known.error()).text());
    return 2;
  }
  std::erase_if(*suite, [](const SuiteQuery& q) { return !q.solvable(); });
  std::vector<Row> rows = preferenceRows(*suite, options, *known);
  const auto rowOf = [&](const char* method) {
    return *std::ranges::find(rows, method, &Row::method);
  };
  if (options.prefer.empty()) {
    std::vector<Row> others = sstRows(*suite, rowOf("natural"), rowOf("fast"), *known);
    std::ranges::move(others, std::back_inserter(rows));
  }
  Report report("quality", options.json ? Report::Form::json : Report::Form::table);
  for (const Row& row : rows) {
    if (options.each) printEach(row, *known);
    reportRow(report, row, *known);
  }
  if (!options.record) return 0;
  const Status written = known->write(table);
  if (!written) fmt::print(stderr, "bench_quality: {}\n", written.error().text());
  return written ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return run(optionsOf(argc, argv)); }
