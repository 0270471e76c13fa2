#include "train/seen_rows.h"

#include <algorithm>

#include "train/unit_sums.h"

namespace obby::train {

namespace {

constexpr int kUnits = policy::kHidden;
constexpr uint32_t kAllLanes = (uint64_t(1) << kLanes) - 1;
constexpr int kAskedLines = 8;  // of cache: what is likely to be read of a row
static_assert(policy::kInputs % kLanes == 0);

using Units = UnitSums<kUnits>;

}  // namespace

void SeenRows::normaliseBy(std::span<const float> means, std::span<const float> scales) {
  means_.assign(means.begin(), means.end());
  scales_.assign(scales.begin(), scales.end());
  for (int i = policy::kStateInputs; i < policy::kInputs; ++i)
    voids_[size_t(i)] =
        policy::normalised(policy::kEmptyInput, means_[size_t(i)], scales_[size_t(i)]);
}

// The player's state is kept whatever it is.
void SeenRows::take(size_t row, const float* raw) {
  constexpr uint64_t kState = (uint64_t(1) << policy::kStateInputs) - 1;
  static_assert(policy::kStateInputs < kBits && kBits % kLanes == 0);
  Row& to = rows_[row];
  std::fill_n(to.seen, kWords, uint64_t(0));
  float* value = to.values;
  for (int i = 0; i < policy::kInputs; i += kLanes) {
    const WideFloat is = load(raw + i);
    const auto state = i < kBits ? uint32_t(kState >> i) & kAllLanes : 0;
    const uint32_t chosen = bitsOf(is != WideFloat(policy::kEmptyInput)) | state;
    const WideFloat shown =
        policy::normalised(is, load(&means_[size_t(i)]), load(&scales_[size_t(i)]));
    storeChosen(shown - load(voids_.data() + i), chosen, value);
    value += bitCount(chosen);
    to.seen[i / kBits] |= uint64_t(chosen) << i % kBits;
  }
}

void voidSums(const SeenRows& rows, const nn::Network<float>& net, std::vector<float>& out) {
  Units sums(net.biases(0));
  for (int i = policy::kStateInputs; i < policy::kInputs; ++i)
    sums.add(net.weights(0) + i * kUnits, rows.voids()[size_t(i)]);
  out.resize(kUnits);
  sums.put(out.data());
}

void addVoidGradients(const SeenRows& rows, const nn::Network<float>& net,
                      std::vector<float>& sums) {
  float* const weights = sums.data() + net.at(0);
  const float* const biases = sums.data() + net.biasesAt(0);
  for (int i = policy::kStateInputs; i < policy::kInputs; ++i) {
    for (int o = 0; o < kUnits; ++o) weights[i * kUnits + o] += rows.voids()[size_t(i)] * biases[o];
  }
}

void SeenPart::ask(size_t i) const {
  const char* const begin = reinterpret_cast<const char*>(&row(i));
  for (int line = 0; line < kAskedLines; ++line) __builtin_prefetch(begin + 64 * line);
}

void SeenPart::firstLayer(const nn::Network<float>& net, float* out) const {
  for (size_t first = 0; first < which_.size(); first += kBlock) {
    const size_t count = std::min(kBlock, which_.size() - first);
    blockLayer(first, count, net.weights(0), out + first * kUnits);
  }
}

// A word of inputs after the other: its weights stay in a core's nearest cache while all rows pass.
void SeenPart::blockLayer(size_t first, size_t count, const float* weights, float* out) const {
  const float* values[kBlock];
  for (size_t i = 0; i < count; ++i) values[i] = row(first + i).values;
  for (int w = 0; w < SeenRows::kWords; ++w, weights += SeenRows::kBits * kUnits) {
    for (size_t i = 0; i < count; ++i) {
      if (w == 0 && first + i + kRowsAhead < which_.size()) ask(first + i + kRowsAhead);
      Units sums(w == 0 ? voidSums_.data() : out + i * kUnits);
      const float* value = values[i];
      forBits(row(first + i).seen[w],
              [&](int bit) OBBY_INLINED { sums.add(weights + bit * kUnits, *value++); });
      values[i] = value;
      sums.put(out + i * kUnits);
    }
  }
}

void SeenPart::addFirstGradient(const nn::Network<float>& net, const float* gradient,
                                std::vector<float>& sums) const {
  Units biases(sums.data() + net.biasesAt(0));
  for (size_t r = 0; r < which_.size(); ++r) biases.add(gradient + r * kUnits);
  biases.put(sums.data() + net.biasesAt(0));
  for (size_t first = 0; first < which_.size(); first += kBlock) {
    const size_t count = std::min(kBlock, which_.size() - first);
    addBlockGradient(first, count, gradient + first * kUnits, sums.data() + net.at(0));
  }
}

// An input after the other: the gradient of its weights is summed in registers over all rows that
// see it.
void SeenPart::addBlockGradient(size_t first, size_t count, const float* gradient,
                                float* sums) const {
  const float* values[kBlock];
  for (size_t i = 0; i < count; ++i) values[i] = row(first + i).values;
  for (int w = 0; w < SeenRows::kWords; ++w) {
    uint64_t seenBy[kBlock] = {};
    for (size_t i = 0; i < count; ++i) seenBy[i] = row(first + i).seen[w];
    transpose(seenBy);
    const int inputs = std::min(SeenRows::kBits, policy::kInputs - w * SeenRows::kBits);
    for (int input = 0; input < inputs; ++input, sums += kUnits) {
      if (seenBy[input] == 0) continue;
      Units sum(sums);
      forBits(seenBy[input],
              [&](int i) OBBY_INLINED { sum.add(gradient + i * kUnits, *values[i]++); });
      sum.put(sums);
    }
  }
}

}  // namespace obby::train
