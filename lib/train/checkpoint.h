// Checkpoints (schema/checkpoint.capnp) let training resume with the same bits. Reading validates
// the whole file. Trainer::resume checks that its worlds fit the levels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "train/settings.h"
#include "train/state.h"

namespace obby::train {

struct Checkpoint {
  std::string program;  // version of the program
  std::vector<Setting> settings;
  double seconds = 0;  // wall clock of all runs so far
  TrainerState state;
};

std::string writeCheckpoint(const Checkpoint& checkpoint);

// Errors say what is wrong with the file; `name` is the input that they name.
Result<Checkpoint> readCheckpoint(std::string_view bytes, const std::string& name);

}  // namespace obby::train
