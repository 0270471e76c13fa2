// Orthogonal initialisation (Saxe et al. 2014). Host only.
#pragma once

#include <cstddef>

#include "base/random.h"

namespace obby::nn {

// Fills the first `columns` columns of `matrix`, (rows, stride). Its columns or its rows, whichever
// are fewer, become orthogonal with length `gain`.
void fillOrthogonal(float* matrix, size_t rows, size_t columns, size_t stride, float gain,
                    Random& random);

}  // namespace obby::nn
