// The table of search methods, one row each. A new method is a file with its settings and its
// selector, and a row here.
#pragma once

#include <string>
#include <vector>

#include "solve/search/method.h"

namespace obby::solve {

const std::vector<Method>& methods();
// Returns null if there is no method of that name.
const Method* findMethod(const std::string& name);

}  // namespace obby::solve
