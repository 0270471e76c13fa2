#include "train/run/metrics.h"

namespace obby::train {

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

}  // namespace obby::train
