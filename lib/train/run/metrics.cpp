#include "train/run/metrics.h"

#include <algorithm>

namespace obby::train {

namespace {

void addSolved(std::vector<Metric>& to, const Solved& solved, uint32_t tries,
               const std::string& prefix) {
  to.push_back({prefix + "levels", double(solved.levels), ""});
  to.push_back({prefix + "solvedLikeliest", solved.likeliest, ""});
  if (tries > 1) to.push_back({prefix + "solvedDrawn", solved.drawn, ""});
  to.push_back({prefix + "solvedAny", solved.any, ""});
}

}  // namespace

std::vector<Metric> metricsOf(const Iteration& i, double seconds, double rate) {
  return {{"decisions", double(i.decisions), ""},
          {"seconds", seconds, "s"},
          {"decisionsPerSecond", rate, "1/s"},
          {"solved", i.solved, ""},
          {"hardest", double(i.hardest), ""},
          {"reward", i.reward, ""},
          {"entropy", i.progress.entropy, "nat"},
          {"approxKl", i.progress.approxKl, "nat"},
          {"clipFraction", i.progress.clipFraction, ""},
          {"valueLoss", i.progress.valueError, ""},
          {"gradNorm", i.progress.gradNorm, ""}};
}

std::vector<Metric> evaluationMetrics(const Evaluation& e, uint32_t tries,
                                      std::span<const std::string> kindNames) {
  std::vector<Metric> out;
  addSolved(out, e, tries, "");
  const auto played = [](const Solved& kind) { return kind.levels > 0; };
  if (std::count_if(e.kinds.begin(), e.kinds.end(), played) < 2) return out;
  for (size_t i = 0; i < std::min(e.kinds.size(), kindNames.size()); ++i) {
    if (played(e.kinds[i]) && !kindNames[i].empty())
      addSolved(out, e.kinds[i], tries, kindNames[i] + "/");
  }
  return out;
}

}  // namespace obby::train
