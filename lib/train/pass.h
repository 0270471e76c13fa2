// Rows on their way through the network and back, as learning does it on the CPU. About half of the
// rectified units are off, and add nothing: products run over what is not zero. Host only; the
// order of sums is fixed, and the same for any number of lanes.
#pragma once

#include "train/seen_rows.h"

namespace obby::train {

// The upper layers' weights by output, as the way back reads them. To be made again when the
// weights change.
struct WeightsBack {
  WeightsBack() = default;
  explicit WeightsBack(const Weights<float>& net) { take(net); }
  // Allocates the first time only.
  void take(const Weights<float>& net) {
    second = net.w[1].transpose();
    third = net.w[2].transpose();
  }

  Rows<float> second, third;  // (kHidden, kHidden), (kPaddedOutputs, kHidden)
};

// Keeps on the way there what the way back asks for. To be used again: as long as the number of
// rows stays, nothing is allocated.
class Pass {
 public:
  // The outputs: (rows, kPaddedOutputs).
  const Rows<float>& forward(const Weights<float>& net, const SeenPart& inputs);

  // After forward(): adds the gradients to `sums`. `slope`: (rows, kPaddedOutputs), of the loss by
  // the outputs.
  void backward(const WeightsBack& net, const SeenPart& inputs, const Rows<float>& slope,
                Weights<float>& sums);

 private:
  Rows<float> a_, b_, out_, slopeA_, slopeB_;
};

}  // namespace obby::train
