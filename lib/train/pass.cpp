#include "train/pass.h"

#include <algorithm>

#include "train/unit_sums.h"

namespace obby::train {

namespace {

constexpr int kHidden = policy::kHidden, kOutputs = policy::kPaddedOutputs;
constexpr size_t kBlock = 64;  // rows that weights' slopes are summed over in registers
constexpr float kNothing[std::max(kHidden, kOutputs)] = {};

// out = begin + in * weights, a row of kOut after the other; `finish` is the last to change it.
template <int kIn, int kOut, class Finish>
OBBY_LANES void product(const Rows<float>& in, const float* begin, const Rows<float>& weights,
                        Rows<float>& out, Finish&& finish) {
  out.resize(in.rows(), kOut);
  for (Eigen::Index r = 0; r < in.rows(); ++r) {
    const float* const row = in.data() + r * kIn;
    UnitSums<kOut> sums(begin);
    forBits(nonZero<kIn>(row),
            [&](int i) OBBY_INLINED { sums.add(weights.data() + i * kOut, row[i]); });
    finish(r, sums);
    sums.put(out.data() + r * kOut);
  }
}

// sums += in^T * slope, of some rows.
template <int kIn, int kOut>
void addBlockSlopes(const float* in, const float* slope, size_t rows, float* sums) {
  uint64_t on[kBlock] = {};
  for (size_t r = 0; r < rows; ++r) on[r] = nonZero<kIn>(in + r * kIn);
  transpose(on);
  for (int i = 0; i < kIn; ++i, sums += kOut) {
    UnitSums<kOut> sum(sums);
    forBits(on[i], [&](int r) OBBY_INLINED { sum.add(slope + r * kOut, in[r * kIn + i]); });
    sum.put(sums);
  }
}

// Adds to the slopes of a layer's weights and biases, by the slopes of its sums.
template <int kIn, int kOut>
void addSlopes(const Rows<float>& in, const Rows<float>& slope, Rows<float>& weights,
               Line<float>& biases) {
  const size_t rows = size_t(in.rows());
  for (size_t first = 0; first < rows; first += kBlock)
    addBlockSlopes<kIn, kOut>(in.data() + first * kIn, slope.data() + first * kOut,
                              std::min(kBlock, rows - first), weights.data());
  addRows<kOut>(slope.data(), rows, biases.data());
}

}  // namespace

const Rows<float>& Pass::forward(const Weights<float>& net, const SeenPart& inputs) {
  inputs.firstLayer(net, a_);
  product<kHidden, kHidden>(a_, net.b[1].data(), net.w[1], b_,
                            [](Eigen::Index, auto& sums) OBBY_INLINED { sums.rectify(); });
  product<kHidden, kOutputs>(b_, net.b[2].data(), net.w[2], out_,
                             [](Eigen::Index, auto&) OBBY_INLINED {});
  return out_;
}

void Pass::backward(const WeightsBack& net, const SeenPart& inputs, const Rows<float>& slope,
                    Weights<float>& sums) {
  addSlopes<kHidden, kOutputs>(b_, slope, sums.w[2], sums.b[2]);
  product<kOutputs, kHidden>(slope, kNothing, net.third, slopeB_,
                             [&](Eigen::Index r, auto& slopes)
                                 OBBY_INLINED { slopes.stopWhereOff(b_.data() + r * kHidden); });
  addSlopes<kHidden, kHidden>(a_, slopeB_, sums.w[1], sums.b[1]);
  product<kHidden, kHidden>(slopeB_, kNothing, net.second, slopeA_,
                            [&](Eigen::Index r, auto& slopes)
                                OBBY_INLINED { slopes.stopWhereOff(a_.data() + r * kHidden); });
  inputs.addFirstSlopes(slopeA_, sums);
}

}  // namespace obby::train
