#include "policy/policy.h"

#include "simd/wide.h"

namespace obby {
// WideFloat's rows, for policy::layer.
OBBY_LANES void loadRow(const float* from, WideFloat& row) { row = load(from); }
OBBY_LANES void storeRow(WideFloat row, float* to) { store(row, to); }
}  // namespace obby

namespace obby::policy {

static_assert(kPaddedPoints % kLanes == 0 && kHidden % kLanes == 0 && kPaddedOutputs % kLanes == 0);

NetworkView Network::view() const {
  const float* at = numbers_.data();
  const size_t* size = kSizes;
  const auto next = [&] {
    const float* const table = at;
    at += *size++;
    return table;
  };
  NetworkView v;
  v.means = next();
  v.scales = next();
  for (LayerView& l : v.layers) {
    l.weights = next();
    l.biases = next();
  }
  return v;
}

Turns observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
              float* inputs) {
  return observe<WideFloat>(scene, world, loose, inputs);
}

void think(const NetworkView& network, const float* inputs, float* outputs) {
  think<WideFloat>(network, inputs, outputs);
}

Pilot::Pilot(const level::LevelView& level, const level::QueryView& query, const Network& network)
    : surroundings_(level, kSight),
      scene_{level, query, surroundings_.view()},
      network_(network.view()) {}

sim::Action Pilot::decide(const sim::World& world, const sim::LooseBody* loose,
                          Random* random) const {
  float inputs[kInputs], outputs[kPaddedOutputs];
  const Turns ahead = observe(scene_, world, loose, inputs);
  think(network_, inputs, outputs);
  const bool mayJump = jumpAllowed(scene_, world);
  const int move =
      random == nullptr ? likeliest(outputs, mayJump) : draw(outputs, mayJump, *random);
  return actionOf(move, ahead);
}

}  // namespace obby::policy
