// Rows of the network's inputs as learning keeps them. Most of a level is empty, and so are two of
// three inputs: a row is what differs from empty surroundings, and which inputs those are, and the
// first layer's sums run over that alone. Host only; the order of sums is fixed, and the same for
// any number of lanes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/huge_pages.h"
#include "nn/unit_sums.h"
#include "policy/trainable.h"

namespace obby::train {

// Rows that are asked for before they are read, where they are read in any order.
constexpr size_t kRowsAhead = 8;

class SeenRows {
 public:
  explicit SeenRows(size_t rows) : rows_(rows) {}

  // By which rows that are taken from now on are normalised: kInputs numbers each. Rows that were
  // taken before mean something else then.
  void normaliseBy(std::span<const float> means, std::span<const float> scales);

  // `raw`: (kInputs), as policy::observe() gives them.
  void take(size_t row, const float* raw);

  // Empty surroundings, normalised: (kInputs).
  const std::vector<float>& voids() const { return voids_; }

 private:
  friend class SeenPart;

  static constexpr int kBits = int(nn::kWord);
  static constexpr int kWords = (policy::kInputs + kBits - 1) / kBits;

  struct alignas(64) Row {
    uint64_t seen[kWords];          // a bit an input: it has a value
    float values[policy::kInputs];  // normalised, less those of empty surroundings; side by side
  };

  std::vector<float> means_, scales_, voids_ = std::vector<float>(policy::kInputs);
  std::vector<Row, HugePages<Row>> rows_;
};

// Fills `out`, (kHidden), with what the first layer makes of empty surroundings: the sums begin
// with it. To be made again when the weights or the rows' normaliser change. In the order of
// policy::Thinker, so that a layer has the bits that the search knows.
void voidSums(const SeenRows& rows, const nn::Network<float>& net, std::vector<float>& out);

// Adds to the first layer's gradient what empty surroundings contribute, once for all rows whose
// gradients are summed in its biases.
void addVoidGradients(const SeenRows& rows, const nn::Network<float>& net,
                      std::vector<float>& sums);

// Some of the rows, as inputs of an nn::Pass.
class SeenPart {
 public:
  // All three must outlive it. `which`: rows.
  SeenPart(const SeenRows& rows, std::span<const uint32_t> which,
           const std::vector<float>& voidSums)
      : rows_(rows), which_(which), voidSums_(voidSums) {}

  size_t rows() const { return which_.size(); }
  void fillFirstLayer(const nn::Network<float>& net, float* out) const;
  void addFirstGradient(const nn::Network<float>& net, const float* gradient,
                        std::vector<float>& sums) const;

 private:
  class Block;  // of rows whose inputs are gone through together

  const SeenRows::Row& row(size_t i) const { return rows_.rows_[which_[i]]; }

  const SeenRows& rows_;
  std::span<const uint32_t> which_;
  const std::vector<float>& voidSums_;
};

}  // namespace obby::train
