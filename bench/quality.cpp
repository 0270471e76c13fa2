// Measures how good solutions are: time, jumps, turns back, key changes and path length of the
// suite's solutions, relative to the best known ones (bench/results/best-known.tsv), and the time
// to the first and the final solution.
//   bench_quality [--json] [--seconds S] [--prefer P] [--record] [--each] [FILE:ID ...]
//     --seconds S   improve each query for S seconds [default: 0.2]
//     --prefer P    only this preference; "first" does not improve [default: all]
//     --record      enter better values into the table of the best known
//     --each        also print each query's ticks, jumps, turns back and key changes, each next to
//                   the best known
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "common/report.h"
#include "quality/best_known.h"
#include "quality/measure.h"
#include "suite/suite.h"

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

// Writes the rows of one preference. `best` is parallel to `all`.
void reportRows(Report& report, const char* name, const std::vector<Quality>& all,
                const std::vector<Quality>& best) {
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

void printEach(const char* preference, const std::string& query, const Quality& q,
               const Quality& best) {
  fmt::print("{:<10} {:<44} {:>5}/{:<5} {:>3}/{:<3} {:>3}/{:<3} {:>4}/{}\n", preference, query,
             q.ticks, best.ticks, q.jumps, best.jumps, q.turnsBack, best.turnsBack, q.changes,
             best.changes);
}

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
  ThreadPool pool(1);
  struct Row {
    std::string preference;
    std::vector<Quality> all;
    std::vector<std::string> names;
  };
  std::vector<Row> rows;
  std::vector<const solve::Preference*> preferences{nullptr};
  for (const solve::Preference& p : solve::preferences()) preferences.push_back(&p);
  for (const solve::Preference* p : preferences) {
    Row row{p == nullptr ? "first" : p->name, {}, {}};
    if (!options.prefer.empty() && row.preference != options.prefer) continue;
    for (const SuiteQuery& q : *suite) {
      const auto quality = measure(q, p, options.seconds, pool);
      if (!quality) continue;  // unsolved within the budget
      known->note(q.name(), *quality);
      row.all.push_back(*quality);
      row.names.push_back(q.name());
    }
    rows.push_back(std::move(row));
  }
  Report report("quality", options.json ? Report::Form::json : Report::Form::table);
  for (const Row& row : rows) {
    std::vector<Quality> best;
    for (const std::string& name : row.names) best.push_back(known->of(name));
    for (size_t i = 0; options.each && i < row.all.size(); ++i)
      printEach(row.preference.c_str(), row.names[i], row.all[i], best[i]);
    reportRows(report, row.preference.c_str(), row.all, best);
  }
  if (!options.record) return 0;
  const Status written = known->write(table);
  if (!written) fmt::print(stderr, "bench_quality: {}\n", written.error().text());
  return written ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) { return run(optionsOf(argc, argv)); }
