// Rows of network inputs, stored sparsely. Most of a level is empty, and so are two thirds of the
// inputs. A row keeps only the inputs that differ from empty surroundings, and the first layer sums
// over those. The order of sums is fixed for any lane width. Host only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/huge_pages.h"
#include "nn/unit_sums.h"
#include "policy/trainable.h"

namespace obby::train {

// Rows to prefetch where rows are read in shuffled order.
constexpr size_t kRowsAhead = 8;

class SeenRows {
 public:
  explicit SeenRows(size_t rows) : rows_(rows) {}

  // Sets the normalisation of rows taken from now on: kInputs numbers each. Rows that were taken
  // earlier become invalid.
  void normaliseBy(std::span<const float> means, std::span<const float> scales);

  // Stores a row. `raw`: (kInputs), from policy::observe().
  void take(size_t row, const float* raw);

  // Returns the normalised inputs of empty surroundings, (kInputs).
  const std::vector<float>& voids() const { return voids_; }

 private:
  friend class SeenPart;

  static constexpr int kBits = int(nn::kWord);
  static constexpr int kWords = (policy::kInputs + kBits - 1) / kBits;

  struct alignas(64) Row {
    uint64_t seen[kWords];          // one bit per input, set if it has a value
    float values[policy::kInputs];  // normalised, less those of empty surroundings; packed
  };

  std::vector<float> means_, scales_, voids_ = std::vector<float>(policy::kInputs);
  std::vector<Row, HugePages<Row>> rows_;
};

// Fills `out`, (kHidden), with the first layer's sums for empty surroundings, from which the sums
// of each row start. Call it again when the weights or the normalisation change. Sums follow the
// order of policy::Thinker, so that a layer has the same bits as in the search.
void voidSums(const SeenRows& rows, const nn::Network<float>& net, std::vector<float>& out);

// Adds the part of the first layer's weight gradient that is due to empty surroundings, once for
// all rows whose gradients are summed in its biases.
void addVoidGradients(const SeenRows& rows, const nn::Network<float>& net,
                      std::vector<float>& sums);

// A selection of rows, as inputs of an nn::Pass.
class SeenPart {
 public:
  // The arguments must outlive this object. `which`: indices of rows.
  SeenPart(const SeenRows& rows, std::span<const uint32_t> which,
           const std::vector<float>& voidSums)
      : rows_(rows), which_(which), voidSums_(voidSums) {}

  size_t rows() const { return which_.size(); }
  void fillFirstLayer(const nn::Network<float>& net, float* out) const;
  void addFirstGradient(const nn::Network<float>& net, const float* gradient,
                        std::vector<float>& sums) const;

 private:
  class Block;  // rows that are processed together

  const SeenRows::Row& row(size_t i) const { return rows_.rows_[which_[i]]; }

  const SeenRows& rows_;
  std::span<const uint32_t> which_;
  const std::vector<float>& voidSums_;
};

}  // namespace obby::train
