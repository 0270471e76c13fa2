// Kernels for advantages and for an optimiser step.
#pragma once

#include "nn/adam.h"
#include "nn/device/sums.h"

namespace obby::nn {

struct AdvantageArguments {
  Rollout rollout;
  float discount, lambda;
  float *advantages, *returns;  // (rows)
};

OBBY_DEVICE void advantagesOfAgent(const AdvantageArguments& a, uint32_t agent) {
  fillAdvantagesOf(a.rollout, agent, a.discount, a.lambda, a.advantages, a.returns);
}

// An optimiser step by a gradient that is a sum over `rows`.
struct StepArguments {
  float *parameters, *momentum, *squares;  // (count)
  const float* gradient;                   // (count), a sum
  uint32_t count;
  float rows;
  double* chunks;  // (chunks)
  float maxGradNorm;
  AdamStep adam;
  float* scale;  // gradient clipping factor, one number
  double* norm;  // sum of gradient norms, one number
};

OBBY_DEVICE void squareChunk(const StepArguments& s, uint32_t i) {
  const uint32_t first = i * kChunk, last = first + kChunk < s.count ? first + kChunk : s.count;
  double sum = 0;
#if defined(__CUDA_ARCH__)
#pragma unroll 8  // keeps several loads in flight, as in addColumn()
#endif
  for (uint32_t k = first; k < last; ++k) sum += double(s.gradient[k]) * double(s.gradient[k]);
  s.chunks[i] = sum;
}

// Runs in one thread.
OBBY_DEVICE void scaleGradient(const StepArguments& s, uint32_t) {
  double sum = 0;
#if defined(__CUDA_ARCH__)
#pragma unroll 8
#endif
  for (uint32_t i = 0; i < chunksOf(s.count); ++i) sum += s.chunks[i];
  const double rows = double(s.rows);
  const float norm = sqrtf32(float(sum / (rows * rows)));
  *s.scale = norm > s.maxGradNorm ? s.maxGradNorm / norm : 1.0f;
  *s.norm += double(norm);
}

OBBY_DEVICE void updateParameter(const StepArguments& s, uint32_t i) {
  const float g = s.gradient[i] / s.rows * *s.scale;
  s.adam.update(g, s.parameters[i], s.momentum[i], s.squares[i]);
}

}  // namespace obby::nn
