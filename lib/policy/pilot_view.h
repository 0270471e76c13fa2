// A policy's numbers as rollouts read them: plain spans, for device code.
#pragma once

#include "nn/row.h"
#include "policy/observation.h"

namespace obby::policy {

constexpr int kHidden = 64;         // units a layer
constexpr int kPaddedOutputs = 48;  // logits, the value, and padding for every number of lanes

// Plain spans, for device code.
struct NetworkView {
  const float* means = nullptr;   // (kInputs), of the observations that the network was trained on
  const float* scales = nullptr;  // (kInputs), 1 / spread of those observations
  const float* voids = nullptr;   // (kInputs), normalised inputs if nothing is in sight
  nn::LayerView layers[3];  // kInputs -> kHidden -> kHidden -> kPaddedOutputs; the first takes
                            // inputs less `voids`, and its biases make up for that
};

template <class Table>
OBBY_DEVICE void forTables(NetworkView& n, Table&& table) {
  table(n.means, kInputs);
  table(n.scales, kInputs);
  table(n.voids, kInputs);
  const uint32_t sizes[] = {uint32_t(kInputs), kHidden, kHidden, kPaddedOutputs};
  for (int l = 0; l < 3; ++l) {
    table(n.layers[l].weights, sizes[l] * sizes[l + 1]);
    table(n.layers[l].biases, sizes[l + 1]);
  }
}

// The data that a policy needs in addition to level and query. Plain data, for device code.
struct PilotView {
  SurroundingsView surroundings;
  NetworkView network;

  OBBY_DEVICE bool exists() const { return network.means != nullptr; }
};

template <class Table>
OBBY_DEVICE void forTables(PilotView& p, Table&& table) {
  if (!p.exists()) return;
  forTables(p.surroundings, table);
  forTables(p.network, table);
}

}  // namespace obby::policy
