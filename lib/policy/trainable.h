// The policy's network as learning has it. Host only.
#pragma once

#include "nn/network.h"
#include "policy/pilot_view.h"

namespace obby::policy {

// All zero; the parameters lie as policy::Network has them behind the normalisers.
template <class S = float>
nn::Network<S> trainableNetwork() {
  return nn::Network<S>({size_t(kInputs), kHidden, kHidden, kPaddedOutputs});
}

}  // namespace obby::policy
