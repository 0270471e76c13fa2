// Search methods that learn while they search, for comparison with the product's methods. The
// programs work without them (CMake option OBBY_BASELINES). A new one is a file with its settings,
// and a row in methods.cpp.
#pragma once

#include <string>
#include <vector>

#include "solve/search/method.h"

namespace obby::baselines {

// Empty in a build without the baselines.
const std::vector<solve::Method>& methods();

// The rows of solve::methods(), then those of methods().
std::vector<const solve::Method*> allMethods();
// Returns null if there is no method of that name in allMethods().
const solve::Method* findMethod(const std::string& name);

}  // namespace obby::baselines
