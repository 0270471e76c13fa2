#include "policy/policy.h"

#include "math/bits.h"
#include "simd/wide.h"

namespace obby {
// WideFloat's rows, for the policy's templates.
OBBY_LANES void loadRow(const float* from, WideFloat& row) { row = load(from); }
OBBY_LANES void storeRow(WideFloat row, float* to) { store(row, to); }
OBBY_LANES float greatestOf(WideFloat row) {
  alignas(64) float lanes[kLanes];
  store(row, lanes);
  for (int half = kLanes / 2; half > 0; half /= 2) {
    for (int k = 0; k < half; ++k) lanes[k] = maxf(lanes[k], lanes[k + half]);
  }
  return lanes[0];
}
}  // namespace obby

namespace obby::policy {

// In a list, so that there is no branch at each of them. Rows come in order, so that the list is no
// longer than what came: storeChosen() writes a whole row at its end.
template <int kMost>
class NonZero<WideFloat, kMost> {
 public:
  OBBY_LANES void put(int first, WideFloat row) {
    const uint32_t chosen = bitsOf(row != WideFloat(0.0f));
    storeChosen(row, chosen, numbers_ + count_);
    storeChosen(floatOfBits(laneNumbers() + first), chosen, indices_ + count_);
    count_ += int(bitCount(chosen));
  }
  template <class Visit>
  OBBY_LANES void forEach(Visit&& visit) const {
    for (int n = 0; n < count_; ++n) visit(__builtin_bit_cast(int32_t, indices_[n]), numbers_[n]);
  }

 private:
  int count_ = 0;
  alignas(64) float numbers_[kMost];
  alignas(64) float indices_[kMost];  // the bits of integers
};

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
  NonZero<float, kInputs> empty;
  for (int i = 0; i < kInputs; ++i) empty.put(i, voids_[size_t(i)]);
  LayerView& first = view_.layers[0];
  layer<float, kHidden>(first, empty, kHidden, [&](int i, float sum) { biases_[size_t(i)] = sum; });
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

sim::Action decideOn(const Scene& scene, const NetworkView& network, const sim::World& world,
                     const float* inputs, Turns ahead, Random* random) {
  return decideOn<WideFloat>(scene, network, world, inputs, ahead, random);
}

}  // namespace obby::policy
