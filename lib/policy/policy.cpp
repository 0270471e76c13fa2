#include "policy/policy.h"

#include "simd/wide.h"

namespace obby {
// WideFloat's rows and masks, for policy::layer.
OBBY_LANES void loadRow(const float* from, WideFloat& row) { row = load(from); }
OBBY_LANES void storeRow(WideFloat row, float* to) { store(row, to); }
OBBY_LANES uint32_t laneBits(WideMask m) { return bitsOf(m); }
}  // namespace obby

namespace obby::policy {

static_assert(kPaddedPoints % kLanes == 0 && kInputs % kLanes == 0 && kHidden % kLanes == 0 &&
              kPaddedOutputs % kLanes == 0);

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
  for (LayerView& l : view_.layers) {
    l.weights = next();
    l.biases = next();
  }
  for (int i = kStateInputs; i < kInputs; ++i) {
    voids_[size_t(i)] = normalised(kEmptyInput, view_.means[i], view_.scales[i]);
  }
  LayerView& first = view_.layers[0];
  layer<float, kHidden>(first, voids_.data(), kInputs, kHidden, false, biases_.data());
  view_.voids = voids_.data();
  first.biases = biases_.data();
}

Turns observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
              float* inputs) {
  return observe<WideFloat>(scene, world, loose, inputs);
}

void observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
             const sim::NextRegion& next, Turns ahead, float* inputs) {
  observe<WideFloat>(scene, world, loose, next, ahead, inputs);
}

void think(const NetworkView& network, const float* inputs, float* outputs) {
  think<WideFloat>(network, inputs, outputs);
}

sim::Action decide(const Scene& scene, const NetworkView& network, const sim::World& world,
                   const sim::LooseBody* loose, Random* random) {
  return decide<WideFloat>(scene, network, world, loose, random);
}

}  // namespace obby::policy
