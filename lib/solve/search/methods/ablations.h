// The method `auto` with one of its ideas left out at a time: what each is worth, for benches. Rows
// like those of methods.h; users are not offered them.
#pragma once

#include "solve/search/methods/methods.h"

namespace obby::solve {

const std::vector<Method>& ablations();

}  // namespace obby::solve
