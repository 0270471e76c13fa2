// Variants of the method `auto`, each with one of its ideas removed. Benchmarks use them to measure
// what each idea is worth. The rows are like those of methods.h, but users are not offered them.
#pragma once

#include "solve/search/method.h"

namespace obby::solve {

const std::vector<Method>& ablations();

}  // namespace obby::solve
