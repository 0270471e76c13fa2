// The policy's network in the form that training uses. Host only.
#pragma once

#include "nn/network.h"
#include "policy/pilot_view.h"

namespace obby::policy {

// Returns a network of zeros. Its parameters have the order of policy::Network without the
// normalisers.
template <class S = float>
nn::Network<S> trainableNetwork() {
  return nn::Network<S>({size_t(kInputs), kHidden, kHidden, kPaddedOutputs});
}

}  // namespace obby::policy
