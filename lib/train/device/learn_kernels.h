// Kernels that learn from a batch, in addition to those of lib/nn. They gather minibatches and
// evaluate the loss of each decision.
#pragma once

#include "base/shuffle.h"
#include "nn/advantages.h"
#include "nn/device/product.h"
#include "policy/decision.h"

namespace obby::train {

// Progress figures summed over decisions.
enum Figure { kLossFigure, kEntropyFigure, kApproxKlFigure, kClippedFigure, kValueFigure };
constexpr int kFigures = 8;  // padded

struct MinibatchArguments {
  const float* inputs;  // inputs of the batch, (rows, kInputs)
  const policy::Decision* decisions;
  const float *advantages, *returns;
  Shuffle shuffle;
  uint32_t first, count;  // range of the shuffled order
  nn::PpoLossSettings loss;
  nn::AdvantageScale scale;
  float valueMean, valueDeviation;
  float* rows;           // (count, kInputs)
  const float* outputs;  // (count, kPaddedOutputs)
  float* gradients;      // (count, kPaddedOutputs)
  float* figures;        // (count, kFigures)
};

constexpr uint32_t kFoursOfRow = policy::kInputs / 4;
static_assert(policy::kInputs % 4 == 0);

// `i` runs over (count, kFoursOfRow).
OBBY_DEVICE void gatherInputs(const MinibatchArguments& p, uint32_t i) {
  const uint32_t place = i / kFoursOfRow, four = i % kFoursOfRow;
  const size_t row = p.shuffle(p.first + place);
  reinterpret_cast<nn::Run<4>*>(p.rows)[i] =
      nn::runAt<4>(p.inputs + row * policy::kInputs + size_t(four) * 4);
}

OBBY_DEVICE void lossOfPlace(const MinibatchArguments& p, uint32_t i) {
  const uint32_t row = p.shuffle(p.first + i);
  policy::Decision d = p.decisions[row];
  d.target = (p.returns[row] - p.valueMean) / p.valueDeviation;
  d.advantage = p.scale(p.advantages[row]);
  const size_t at = size_t(i) * policy::kPaddedOutputs;
  const auto r = policy::ppoLossOf(p.outputs + at, d, p.loss, p.gradients + at);
  float* const figures = p.figures + size_t(i) * kFigures;
  figures[kLossFigure] = r.loss;
  figures[kEntropyFigure] = r.entropy;
  figures[kApproxKlFigure] = r.approxKl;
  figures[kClippedFigure] = r.clipped ? 1.0f : 0.0f;
  figures[kValueFigure] = r.valueError * r.valueError;
  for (int f = kValueFigure + 1; f < kFigures; ++f) figures[f] = 0;
}

// Rescales the value head when the scale of its outputs changes; see Ppo::rescaleValues.
struct RescaleArguments {
  float *weights, *bias;  // the last layer's
  float oldMean, oldDeviation, mean, deviation;
};

OBBY_DEVICE void rescaleOne(const RescaleArguments& r, uint32_t i) {
  r.weights[size_t(i) * policy::kPaddedOutputs + policy::kMoves] *= r.oldDeviation / r.deviation;
  if (i != 0) return;
  float& bias = r.bias[policy::kMoves];
  bias = (bias * r.oldDeviation + r.oldMean - r.mean) / r.deviation;
}

}  // namespace obby::train
