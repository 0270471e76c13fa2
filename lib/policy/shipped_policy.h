// The policy that is built into the programs (policies/README.md says how it was made).
#pragma once

#include "policy/policy_file.h"

namespace obby::policy {

// Returns the policy, which is read and checked at the first call. Thread-safe.
const PolicyFile& shippedPolicy();

}  // namespace obby::policy
