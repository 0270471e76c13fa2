// What a change of how a policy learns is worth: it learns with the change, from the same levels
// for as many decisions, and then plays levels that none was trained on. The mean of some seeds,
// with the least and the most. Takes about a minute a row and seed for each 30 million decisions.
#pragma once

#include <functional>
#include <vector>

#include "train/trainer.h"

namespace obby::bench {

struct LearningRow {
  const char* name;
  std::function<void(train::TrainerSettings&)> change;  // of the defaults
};

// A bench's main(): bench_NAME [--json] [--decisions N] [--seeds N] [--recipe FILE] [ROW...].
// Without a recipe levels are of all styles, trivial to limit.
int learningBench(int argc, char** argv, const char* bench, const std::vector<LearningRow>& rows);

}  // namespace obby::bench
