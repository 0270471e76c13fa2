#include "train/metrics.h"

namespace obby::train {

std::vector<Metric> metricsOf(const Iteration& i, double seconds, double rate) {
  return {{"decisions", double(i.decisions), ""},    {"seconds", seconds, "s", true},
          {"decisionsPerSecond", rate, "1/s", true}, {"solved", i.solved, ""},
          {"hardest", double(i.hardest), ""},        {"reward", i.reward, ""},
          {"entropy", i.progress.entropy, "nat"},    {"divergence", i.progress.approxKl, "nat"},
          {"clipped", i.progress.clipFraction, ""},  {"valueError", i.progress.valueError, ""},
          {"gradient", i.progress.gradNorm, ""}};
}

}  // namespace obby::train
