// Policy files (schema/policy.capnp). Reading checks everything: a file is refused, or what it
// holds can be used. Host only.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "policy/policy.h"

namespace obby::policy {

// How a policy came to be, for people: PolicyTraining of schema/policy.capnp has the units.
struct Training {
  std::string command, version;
  uint64_t seed = 0, decisions = 0;
  double seconds = 0;
  float hardest = 0, solved = 0;
  std::string start;
};

// What the value's output means: a reward of mean + deviation x output. Deviation 0: not known.
struct ValueUnits {
  float mean = 0, deviation = 0;
};

struct PolicyFile {
  Network network;
  Training training;
  ValueUnits values;
};

std::string writePolicy(const PolicyFile& policy);

// The error says what of the file is wrong; its input is `name`.
Result<PolicyFile> readPolicy(std::string_view bytes, const std::string& name);

}  // namespace obby::policy
