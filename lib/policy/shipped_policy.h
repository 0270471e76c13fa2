// The policy that the programs come with (policies/README.md says how it was made).
#pragma once

#include "policy/policy_file.h"

namespace obby::policy {

// Read and checked at the first call; safe to call from several threads.
const PolicyFile& shippedPolicy();

}  // namespace obby::policy
