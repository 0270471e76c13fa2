// This module extends `solve`. It uses that module's problems, archive and rollouts by their own
// names.
#pragma once

namespace obby::solve {}

namespace obby::baselines {
using namespace solve;
}  // namespace obby::baselines
