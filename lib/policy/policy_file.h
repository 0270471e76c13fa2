// Policy files (schema/policy.capnp). Reading checks everything: a file is either rejected or
// usable. Host only.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "policy/policy.h"

namespace obby::policy {

// Information about a policy's training, for display. PolicyTraining of schema/policy.capnp has the
// units.
struct Training {
  std::string command, version;
  uint64_t seed = 0, decisions = 0;
  double seconds = 0;
  float hardest = 0, solved = 0;
  std::string start;
};

// Units of the value output: a reward is mean + deviation x output. Deviation 0 means unknown.
struct ValueUnits {
  float mean = 0, deviation = 0;
};

struct PolicyFile {
  Network network;
  Training training;
  ValueUnits values;
};

// Returns the bytes of the file.
std::string writePolicy(const PolicyFile& policy);

// Reads a policy. An error says what is wrong with the file, and has `name` as its input.
Result<PolicyFile> readPolicy(std::string_view bytes, const std::string& name);

}  // namespace obby::policy
