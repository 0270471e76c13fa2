// The policy that training starts from instead of a fresh network.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "train/ranks.h"
#include "train/start.h"

namespace obby::train {

struct StartPolicy {
  Start start;
  std::string name;  // identifies the policy by the hash of its file
};

// The first rank reads the file for all ranks; an empty path returns no policy. Errors: those of
// the file.
Result<std::optional<StartPolicy>> readStartPolicy(const std::string& path, Ranks& ranks,
                                                   const std::atomic<bool>& stop);

}  // namespace obby::train
