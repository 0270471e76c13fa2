// Training settings as names and values. A checkpoint can be resumed only under equal settings.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "train/trainer.h"

namespace obby::train {

struct Setting {
  std::string name, value;
};

// Returns all settings that affect training, apart from the levels. Numbers are their shortest
// decimals.
std::vector<Setting> settingsOf(const TrainerSettings& settings);

// Returns the name that a setting of an earlier version has now.
std::string presentSettingName(const std::string& name);

// Returns an error that names the first differing setting, with both values.
Status sameSettings(const std::vector<Setting>& then, const std::vector<Setting>& now);

}  // namespace obby::train
