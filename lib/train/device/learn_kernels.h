// Learning from a batch as kernels, apart from products and sums: advantages, the part of a pass
// side by side, the loss of each decision, a step of the optimiser.
#pragma once

#include "policy/adam.h"
#include "policy/advantages.h"
#include "policy/ppo_loss.h"
#include "train/device/sums.h"

namespace obby::train {

struct AdvantageArguments {
  policy::Played played;
  float discount, lambda;
  float *advantages, *targets;  // (rows)
};

OBBY_DEVICE void advantagesOfWorld(const AdvantageArguments& a, uint32_t world) {
  policy::fillAdvantagesOf(a.played, world, a.discount, a.lambda, a.advantages, a.targets);
}

// What is summed of each decision for people.
enum Figure { kLossFigure, kEntropyFigure, kDivergenceFigure, kClippedFigure, kValueFigure };
constexpr int kFigures = 8;  // with padding

struct PartArguments {
  const float* inputs;  // of the batch: (rows, kInputs)
  const policy::Decision* decisions;
  const float *advantages, *targets;
  Shuffle shuffle;
  uint32_t first, count;  // places of the shuffle
  policy::LossSettings loss;
  float advantageMean, advantageScale, valueMean, valueDeviation;
  float* rows;           // (count, kInputs)
  const float* outputs;  // (count, kPaddedOutputs)
  float* slopes;         // (count, kPaddedOutputs)
  float* figures;        // (count, kFigures)
};

constexpr uint32_t kFoursOfRow = policy::kInputs / 4;
static_assert(policy::kInputs % 4 == 0);

// `i`: of (count, kFoursOfRow).
OBBY_DEVICE void gatherInputs(const PartArguments& p, uint32_t i) {
  const uint32_t place = i / kFoursOfRow, four = i % kFoursOfRow;
  const size_t row = p.shuffle(p.first + place);
  reinterpret_cast<Four*>(p.rows)[i] =
      reinterpret_cast<const Four*>(p.inputs + row * policy::kInputs)[four];
}

OBBY_DEVICE void lossOfPlace(const PartArguments& p, uint32_t i) {
  const uint32_t row = p.shuffle(p.first + i);
  policy::Decision d = p.decisions[row];
  d.target = (p.targets[row] - p.valueMean) / p.valueDeviation;
  d.advantage = (p.advantages[row] - p.advantageMean) * p.advantageScale;
  const size_t at = size_t(i) * policy::kPaddedOutputs;
  const auto r = policy::lossOf(p.outputs + at, d, p.loss, p.slopes + at);
  float* const figures = p.figures + size_t(i) * kFigures;
  figures[kLossFigure] = r.loss;
  figures[kEntropyFigure] = r.entropy;
  figures[kDivergenceFigure] = r.divergence;
  figures[kClippedFigure] = r.clipped ? 1.0f : 0.0f;
  figures[kValueFigure] = r.valueError * r.valueError;
  for (int f = kValueFigure + 1; f < kFigures; ++f) figures[f] = 0;
}

// A step of the optimiser, from a gradient that is a sum over `decisions`.
struct StepArguments {
  float *weights, *momentum, *squares;  // (count)
  const float* gradient;                // (count), a sum
  uint32_t count;
  float decisions;
  Moments* chunks;  // (chunks)
  float mostNorm;
  policy::AdamStep adam;
  float* scale;  // of the gradient: one number
  double* norm;  // grows by the gradient's: one number
};

OBBY_DEVICE void squareChunk(const StepArguments& s, uint32_t i) {
  const uint32_t first = i * kChunk, last = first + kChunk < s.count ? first + kChunk : s.count;
  double sum = 0;
#if defined(__CUDA_ARCH__)
#pragma unroll 8  // several numbers are on their way at once, as in addColumn()
#endif
  for (uint32_t k = first; k < last; ++k) sum += double(s.gradient[k]) * double(s.gradient[k]);
  s.chunks[i] = {0, sum};
}

// One thread.
OBBY_DEVICE void scaleGradient(const StepArguments& s, uint32_t) {
  double sum = 0;
#if defined(__CUDA_ARCH__)
#pragma unroll 8
#endif
  for (uint32_t i = 0; i < chunksOf(s.count); ++i) sum += s.chunks[i].squares;
  const double decisions = double(s.decisions);
  const float norm = sqrtf32(float(sum / (decisions * decisions)));
  *s.scale = norm > s.mostNorm ? s.mostNorm / norm : 1.0f;
  *s.norm += double(norm);
}

OBBY_DEVICE void moveWeight(const StepArguments& s, uint32_t i) {
  const float g = s.gradient[i] / s.decisions * *s.scale;
  s.adam.update(g, s.weights[i], s.momentum[i], s.squares[i]);
}

// The value head's weights, when what its outputs mean moves: see Ppo::rescaleValues.
struct RescaleArguments {
  float *weights, *bias;  // of the last layer
  float oldMean, oldDeviation, mean, deviation;
};

OBBY_DEVICE void rescaleOne(const RescaleArguments& r, uint32_t i) {
  r.weights[size_t(i) * policy::kPaddedOutputs + policy::kMoves] *= r.oldDeviation / r.deviation;
  if (i != 0) return;
  float& bias = r.bias[policy::kMoves];
  bias = (bias * r.oldDeviation + r.oldMean - r.mean) / r.deviation;
}

}  // namespace obby::train
