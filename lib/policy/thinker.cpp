#include "policy/policy.h"

namespace obby::policy {

Thinker::Thinker(const Network& network) : voids_(kInputs), biases_(kHidden) {
  const float* at = network.numbers().data();
  const size_t* size = Network::kSizes;
  const auto next = [&] {
    const float* const table = at;
    at += *size++;
    return table;
  };
  view_.means = next();
  view_.scales = next();
  for (nn::LayerView& l : view_.layers) {
    l.weights = next();
    l.biases = next();
  }
  for (int i = kStateInputs; i < kInputs; ++i) {
    voids_[size_t(i)] = normalised(kEmptyInput, view_.means[i], view_.scales[i]);
  }
  nn::NonZero<float, kInputs> empty;
  for (int i = 0; i < kInputs; ++i) empty.put(i, voids_[size_t(i)]);
  nn::LayerView& first = view_.layers[0];
  nn::linearRow<float, kHidden>(first, empty, kHidden,
                                [&](int i, float sum) { biases_[size_t(i)] = sum; });
  view_.voids = voids_.data();
  first.biases = biases_.data();
}

}  // namespace obby::policy
