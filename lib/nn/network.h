// A feed-forward network of dense layers with rectified units between them. A template on the
// number type, so that tests can check gradients in double precision. Host only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/random.h"
#include "math/lanes.h"
#include "nn/product.h"

namespace obby::nn {

// Returns the smallest multiple of kColumns that is at least `count`.
constexpr size_t padded(size_t count) { return (count + kColumns - 1) / kColumns * kColumns; }

template <class S>
class Network {
 public:
  // `sizes`: units of each layer, the inputs first. All but the inputs must be multiples of
  // kColumns.
  explicit Network(std::vector<size_t> sizes) : sizes_(std::move(sizes)) {
    size_t count = 0;
    for (size_t l = 0; l < layers(); ++l) {
      OBBY_CHECK_EQ(outputs(l) % kColumns, 0u);
      at_.push_back(count);
      count += (inputs(l) + 1) * outputs(l);
    }
    parameters_.assign(count, S(0));
  }

  size_t layers() const { return sizes_.size() - 1; }
  size_t inputs(size_t l) const { return sizes_[l]; }
  size_t outputs(size_t l) const { return sizes_[l + 1]; }
  size_t outputs() const { return sizes_.back(); }

  // Returns for each layer its weights, then its biases. The non-const overload increments
  // version().
  std::vector<S>& parameters() {
    ++version_;
    return parameters_;
  }
  const std::vector<S>& parameters() const { return parameters_; }
  size_t at(size_t l) const { return at_[l]; }  // offset of weights, (inputs, outputs)
  size_t biasesAt(size_t l) const { return at_[l] + inputs(l) * outputs(l); }  // (outputs)
  const S* weights(size_t l) const { return parameters_.data() + at(l); }
  const S* biases(size_t l) const { return parameters_.data() + biasesAt(l); }
  uint64_t version() const { return version_; }  // grows with each change; at least 1

 private:
  std::vector<size_t> sizes_, at_;
  std::vector<S> parameters_;
  uint64_t version_ = 1;
};

// Draws weights uniformly within sqrt(6 / inputs) (He et al. 2015), those of the last layer times
// `gain`. Leaves the biases as they are.
inline void fillUniform(Network<float>& net, float gain, Random& random) {
  for (size_t l = 0; l < net.layers(); ++l) {
    const float max = sqrtf32(6.0f / float(net.inputs(l))) * (l + 1 == net.layers() ? gain : 1);
    float* const w = net.parameters().data() + net.at(l);
    for (size_t i = 0; i < net.inputs(l) * net.outputs(l); ++i)
      w[i] = max * (2 * random.unit() - 1);
  }
}

}  // namespace obby::nn
