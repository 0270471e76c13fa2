// The settings of learning as names and values, for a checkpoint to be gone on from only under
// those that it was made under.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "train/trainer.h"

namespace obby::train {

struct Setting {
  std::string name, value;
};

// All that decides what is learned, apart from the levels. Numbers are their shortest decimals.
std::vector<Setting> settingsOf(const TrainerSettings& settings);

// The error names the first setting that differs, with both values.
Status sameSettings(const std::vector<Setting>& then, const std::vector<Setting>& now);

}  // namespace obby::train
