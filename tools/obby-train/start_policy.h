// The policy that learning begins with, by --start-from.
#pragma once

#include <optional>
#include <string>

#include "cli/context.h"
#include "train/ranks.h"
#include "train/start.h"

namespace obby::tools {

struct StartPolicy {
  train::Start start;
  std::string name;  // tells it from others, by the hash of its file
};

// None without the option. Read by the first rank, the same on every rank. Errors: the file's.
Result<std::optional<StartPolicy>> startPolicyOf(const cli::Context& context, train::Ranks& ranks);

}  // namespace obby::tools
