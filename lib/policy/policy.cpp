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

namespace obby::nn {

// Keeps the non-zero numbers in a list, so that forEach() has no branch for each number.
// storeChosen() writes a whole row at the end of the list. The row fits, since rows come in order
// and the list is no longer than the rows before.
template <int kMax>
class NonZero<WideFloat, kMax> {
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
  alignas(64) float numbers_[kMax];
  alignas(64) float indices_[kMax];  // the bits of integers
};

}  // namespace obby::nn

namespace obby::policy {

static_assert(kPaddedPoints % kLanes == 0 && kInputs % kLanes == 0 && kHidden % kLanes == 0 &&
              kPaddedOutputs % kLanes == 0);

Turns observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
              float* inputs) {
  return observe<WideFloat>(scene, world, bodies, inputs);
}

void observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
             const sim::NextRegion& next, Turns ahead, float* inputs) {
  observe<WideFloat>(scene, world, bodies, next, ahead, inputs);
}

void think(const NetworkView& network, const float* inputs, float* outputs) {
  think<WideFloat>(network, inputs, outputs);
}

sim::Action decide(const Scene& scene, const NetworkView& network, const sim::World& world,
                   const sim::RigidBody* bodies, Random* random) {
  return decide<WideFloat>(scene, network, world, bodies, random);
}

sim::Action decideOn(const Scene& scene, const NetworkView& network, const sim::World& world,
                     const float* inputs, Turns ahead, Random* random) {
  return decideOn<WideFloat>(scene, network, world, inputs, ahead, random);
}

}  // namespace obby::policy
