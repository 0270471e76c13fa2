// Checkpoints (schema/checkpoint.capnp): learning that was broken off, to go on with the same bits.
// Reading checks everything: a file is refused, or all of it is as it was written. Whether its
// worlds fit the levels is for Trainer::resume to say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "train/history.h"
#include "train/settings.h"
#include "train/state.h"

namespace obby::train {

struct Checkpoint {
  std::string program;  // its version
  std::vector<Setting> settings;
  double seconds = 0;  // wall clock so far, of all runs
  TrainerState state;
  History history;
};

std::string writeCheckpoint(const Checkpoint& checkpoint);

// The error says what of the file is wrong; its input is `name`.
Result<Checkpoint> readCheckpoint(std::string_view bytes, const std::string& name);

}  // namespace obby::train
