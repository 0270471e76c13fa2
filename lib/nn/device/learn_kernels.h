// What learning does as kernels, apart from products and sums: advantages, and a step of the
// optimiser.
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

// A step of the optimiser, from a gradient that is a sum over `rows`.
struct StepArguments {
  float *parameters, *momentum, *squares;  // (count)
  const float* gradient;                   // (count), a sum
  uint32_t count;
  float rows;
  double* chunks;  // (chunks)
  float maxGradNorm;
  AdamStep adam;
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
  s.chunks[i] = sum;
}

// One thread.
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
