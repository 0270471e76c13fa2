// This module extends `solve`: it uses its problems, archive and rollouts under their own names.
#pragma once

namespace obby::solve {}

namespace obby::baselines {
using namespace solve;
}  // namespace obby::baselines
