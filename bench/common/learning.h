// Measures the value of a change to training. The policy trains with the change on the same levels
// for the same number of decisions, then plays unseen levels. Reports the mean, minimum and maximum
// over several seeds. A row takes about a minute per seed and 30 million decisions.
#pragma once

#include <functional>
#include <vector>

#include "train/trainer.h"

namespace obby::bench {

struct LearningRow {
  const char* name;
  std::function<void(train::TrainerSettings&)> change;  // changes the default settings
};

// A bench's main(): bench_NAME [--json] [--decisions N] [--seeds N] [--recipe FILE] [ROW...].
// Without a recipe, levels of all styles are used, at difficulties from trivial to limit.
int learningBench(int argc, char** argv, const char* bench, const std::vector<LearningRow>& rows);

}  // namespace obby::bench
