#include "train/mlp.h"

namespace obby::train {

template class Pass<float>;

}  // namespace obby::train
