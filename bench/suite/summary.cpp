#include "suite/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/quantile.h"

namespace obby::bench {
namespace {

constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

using Picks = std::vector<size_t>;
using RunsFigure = std::function<double(const std::vector<Timing>&)>;

// The runs of one method for some solvable queries, query by query.
class Sample {
 public:
  Sample(const Results& results, size_t method, const std::function<bool(size_t)>& wanted) {
    for (size_t q = 0; q < results.queries.size(); ++q) {
      const std::vector<Run>& runs = results.runs[method][q];
      if (runs.empty() || !results.queries[q].solvable() || !wanted(q)) continue;
      queries_.emplace_back();
      for (const Run& run : runs) queries_.back().push_back(run.timing);
    }
  }

  size_t size() const { return queries_.size(); }

  // Returns the mean over queries of the mean over their runs. Every query has the same weight,
  // whatever its number of seeds.
  double mean(const Picks& picks, const std::function<double(const Timing&)>& figure) const {
    std::vector<double> means;
    for (const size_t q : picks) {
      std::vector<double> values;
      for (const Timing& run : queries_[q]) values.push_back(figure(run));
      means.push_back(bench::mean(values));
    }
    return bench::mean(means);
  }

  std::vector<double> values(const Picks& picks,
                             const std::function<double(const Timing&)>& figure) const {
    std::vector<double> all;
    for (const size_t q : picks) {
      for (const Timing& run : queries_[q]) all.push_back(figure(run));
    }
    return all;
  }

  Picks all() const {
    Picks picks(queries_.size());
    for (size_t q = 0; q < picks.size(); ++q) picks[q] = q;
    return picks;
  }

 private:
  std::vector<std::vector<Timing>> queries_;
};

bool any(size_t) { return true; }

// Computes the measures of one method.
class Summary {
 public:
  Summary(const Results& results, size_t method, std::vector<Measure>& out)
      : results_(results), method_(method), cap_(results.cap), out_(out) {}

  void addAll() {
    const Sample sample(results_, method_, any);
    add("queries", double(sample.size()), "");
    addShares();
    addTimes(sample);
    addWork(sample);
    addThirdsByGe();
    addThirdsByEffort();
    addRatio();
    addVerdicts();
  }

 private:
  void add(std::string metric, double value, const char* unit,
           std::optional<Interval> interval = {}) {
    out_.push_back({results_.methods[method_], std::move(metric), value, interval, unit});
  }

  // Adds a statistic over all queries, with its interval.
  void addWithInterval(const char* metric, const char* unit, size_t queries,
                       const GroupStatistic& statistic) {
    Picks all(queries);
    for (size_t q = 0; q < queries; ++q) all[q] = q;
    add(metric, statistic(all), unit, bootstrap(queries, statistic));
  }

  void addShares() {
    for (const int limit : {1, 3, 10, 30, 90}) {
      if (limit > cap_ && limit != 90) continue;
      const Share share = solvedShares(results_, method_, {std::min(double(limit), cap_)})[0];
      add(fmt::format("solvedShare{}", limit), share.value, "", share.interval);
    }
  }

  std::function<double(const Timing&)> capped() const {
    return [cap = cap_](const Timing& run) { return cappedSeconds(run, cap); };
  }
  std::function<double(const Timing&)> penalised() const {
    return [cap = cap_](const Timing& run) { return par2(run, cap); };
  }

  void addPar2(const char* metric, const Sample& s) {
    addWithInterval(metric, "s", s.size(),
                    [&](const Picks& picks) { return s.mean(picks, penalised()); });
  }

  void addTimes(const Sample& s) {
    addPar2("par2Seconds", s);
    addWithInterval("medianSeconds", "s", s.size(),
                    [&](const Picks& picks) { return quantile(s.values(picks, capped()), 0.5); });
    addMeanAndQuartiles("mean", "lowerQuartile", "upperQuartile", s);
  }

  void addMeanAndQuartiles(const std::string& meanName, const std::string& lower,
                           const std::string& upper, const Sample& s) {
    add(meanName + "Seconds", s.mean(s.all(), capped()), "s");
    add(lower + "Seconds", quantile(s.values(s.all(), capped()), 0.25), "s");
    add(upper + "Seconds", quantile(s.values(s.all(), capped()), 0.75), "s");
  }

  void addWork(const Sample& s) {
    const auto median = [&](const std::function<double(const Timing&)>& figure) {
      return quantile(s.values(s.all(), figure), 0.5);
    };
    add("medianSteps", median([](const Timing& run) { return run.steps; }), "ticks");
    add("medianRounds", median([](const Timing& run) { return run.rounds; }), "");
  }

  // Returns each solvable query's third by `key`, or -1 if the key is NaN.
  std::vector<int> thirdsBy(const std::function<double(size_t)>& key) const {
    std::vector<double> keys;
    Picks queries;
    for (size_t q = 0; q < results_.queries.size(); ++q) {
      if (!results_.queries[q].solvable() || std::isnan(key(q))) continue;
      keys.push_back(key(q));
      queries.push_back(q);
    }
    const std::vector<int> third = thirds(keys);
    std::vector<int> of(results_.queries.size(), -1);
    for (size_t i = 0; i < queries.size(); ++i) of[queries[i]] = third[i];
    return of;
  }

  void addThirdsByGe() {
    const auto ge = std::find(results_.methods.begin(), results_.methods.end(), "ge");
    if (ge == results_.methods.end()) return;
    const auto& runs = results_.runs[size_t(ge - results_.methods.begin())];
    const std::vector<int> third = thirdsBy([&](size_t q) {
      std::vector<double> seconds;
      for (const Run& run : runs[q]) seconds.push_back(cappedSeconds(run.timing, cap_));
      return mean(seconds);
    });
    const char* const names[] = {"geShort", "geMedium", "geLong"};
    for (int t = 0; t < 3; ++t) {
      const std::string name = names[t];
      const Sample s(results_, method_, [&](size_t q) { return third[q] == t; });
      addMeanAndQuartiles(name + "Mean", name + "LowerQuartile", name + "UpperQuartile", s);
      if (t == 2) addPar2("geLongPar2Seconds", s);
    }
  }

  void addThirdsByEffort() {
    const std::vector<int> third = thirdsBy([&](size_t q) { return results_.queries[q].effort; });
    const char* const names[] = {"easyThirdMeanSeconds", "middleThirdMeanSeconds",
                                 "hardThirdMeanSeconds"};
    for (int t = 0; t < 3; ++t) {
      const Sample s(results_, method_, [&](size_t q) { return third[q] == t; });
      addWithInterval(names[t], "s", s.size(),
                      [&](const Picks& picks) { return s.mean(picks, capped()); });
    }
    const Sample hard(results_, method_, [&](size_t q) { return third[q] == 2; });
    const auto solved = [&](const Timing& run) { return par2(run, cap_) <= cap_ ? 1.0 : 0.0; };
    addPar2("hardThirdPar2Seconds", hard);
    add("hardThirdSolvedShare", hard.mean(hard.all(), solved), "");
  }

  void addRatio() {
    const auto found = std::find(results_.methods.begin(), results_.methods.end(), "ge");
    if (found == results_.methods.end()) return;
    const size_t ge = size_t(found - results_.methods.begin());
    const auto both = [&](size_t q) {
      return !results_.runs[ge][q].empty() && !results_.runs[method_][q].empty();
    };
    const Sample theirs(results_, ge, both), ours(results_, method_, both);
    addWithInterval("par2RatioToGe", "", ours.size(), [&](const Picks& picks) {
      return theirs.mean(picks, penalised()) / ours.mean(picks, penalised());
    });
  }

  void addVerdicts() {
    double wrong = 0, proved = 0, provable = 0;
    for (size_t q = 0; q < results_.queries.size(); ++q) {
      const Asked& asked = results_.queries[q];
      for (const Run& run : results_.runs[method_][q]) {
        wrong += run.verdict == (asked.solvable() ? "unreachable" : "solved");
        if (asked.expected != "unreachable") continue;
        ++provable;
        proved += run.verdict == "unreachable";
      }
    }
    add("falseVerdicts", wrong, "");
    add("provedShare", provable > 0 ? proved / provable : kUnmeasured, "");
  }

  const Results& results_;
  const size_t method_;
  const double cap_;
  std::vector<Measure>& out_;
};

}  // namespace

std::vector<Measure> summarise(const Results& results) {
  std::vector<Measure> measures;
  for (size_t m = 0; m < results.methods.size(); ++m) Summary(results, m, measures).addAll();
  return measures;
}

const Measure* findMeasure(const std::vector<Measure>& measures, const std::string& method,
                           const std::string& metric) {
  for (const Measure& m : measures) {
    if (m.method == method && m.metric == metric) return &m;
  }
  return nullptr;
}

std::vector<Share> solvedShares(const Results& results, size_t method,
                                const std::vector<double>& limits) {
  const Sample s(results, method, any);
  std::vector<Share> shares;
  for (const double limit : limits) {
    const GroupStatistic share = [&](const Picks& picks) {
      return s.mean(picks, [&](const Timing& run) { return run.solved && run.seconds <= limit; });
    };
    shares.push_back({share(s.all()), bootstrap(s.size(), share)});
  }
  return shares;
}

std::string slowest(const Results& results, size_t method, size_t count) {
  struct Entry {
    double seconds;
    std::string line;
  };
  std::vector<Entry> entries;
  for (size_t q = 0; q < results.queries.size(); ++q) {
    const std::vector<Run>& runs = results.runs[method][q];
    if (!results.queries[q].solvable() || runs.empty()) continue;
    std::vector<double> seconds;
    int solved = 0;
    for (const Run& run : runs) {
      seconds.push_back(cappedSeconds(run.timing, results.cap));
      solved += run.timing.solved;
    }
    entries.push_back(
        {mean(seconds), fmt::format("  {:8.2f} s  {:>2} of {:<2} solved  {}\n", mean(seconds),
                                    solved, runs.size(), results.queries[q].name)});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.seconds > b.seconds; });
  std::string text;
  for (size_t i = 0; i < std::min(count, entries.size()); ++i) text += entries[i].line;
  return text;
}

}  // namespace obby::bench
