#include "evaluation_metrics.h"

#include <algorithm>
#include <string>

#include "gen/styles.h"

namespace obby::tools {

namespace {

void add(std::vector<train::Metric>& to, const train::Solved& solved, uint32_t tries,
         const std::string& before) {
  to.push_back({before + "levels", double(solved.levels), ""});
  to.push_back({before + "solvedLikeliest", solved.likeliest, ""});
  if (tries > 1) to.push_back({before + "solvedDrawn", solved.drawn, ""});
  to.push_back({before + "solvedAny", solved.any, ""});
}

}  // namespace

uint16_t styleNumberOf(const train::TrainingLevel& level) {
  const gen::Style* const style = gen::styleOfLevel(level.name());
  return style == nullptr ? uint16_t(0) : uint16_t(style - gen::styles().data() + 1);
}

std::vector<train::Metric> evaluationMetrics(const train::Evaluation& e, uint32_t tries) {
  std::vector<train::Metric> out;
  add(out, e, tries, "");
  const auto played = [](const train::Solved& kind) { return kind.levels > 0; };
  if (std::count_if(e.kinds.begin(), e.kinds.end(), played) < 2) return out;
  for (size_t i = 1; i < e.kinds.size(); ++i) {
    if (played(e.kinds[i]))
      add(out, e.kinds[i], tries, std::string(gen::styles()[i - 1].name) + "/");
  }
  return out;
}

}  // namespace obby::tools
