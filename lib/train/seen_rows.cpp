#include "train/seen_rows.h"

#include <algorithm>
#include <type_traits>

#include "policy/network.h"

namespace obby::train {

namespace {

constexpr int kUnits = policy::kHidden;
constexpr std::integral_constant<size_t, kUnits> kWidth{};
constexpr std::integral_constant<size_t, policy::kInputs> kInputs{};
constexpr uint32_t kAllLanes = (uint64_t(1) << kLanes) - 1;
constexpr int kAskedLines = 8;  // cache lines of a row that are worth a prefetch
static_assert(policy::kInputs % kLanes == 0);

using Units = nn::UnitSums<kUnits>;

}  // namespace

void SeenRows::normaliseBy(std::span<const float> means, std::span<const float> scales) {
  means_.assign(means.begin(), means.end());
  scales_.assign(scales.begin(), scales.end());
  for (int i = policy::kStateInputs; i < policy::kInputs; ++i)
    voids_[size_t(i)] =
        policy::normalised(policy::kEmptyInput, means_[size_t(i)], scales_[size_t(i)]);
}

// The inputs of the player's state are always kept.
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

// Accessors for the functions of nn/unit_sums.h.
class SeenPart::Block {
 public:
  struct Cursor {
    const float* at;
    OBBY_LANES float operator()(int) { return *at++; }
  };

  Block(const SeenPart& part, size_t first)
      : part_(part), first_(first), count_(std::min(nn::kRowBlock, part.rows() - first)) {
    for (size_t r = 0; r < count_; ++r) values_[r] = part_.row(first_ + r).values;
  }

  size_t count() const { return count_; }
  OBBY_LANES uint64_t bits(size_t r, size_t w) const {
    if (w == 0 && first_ + r + kRowsAhead < part_.rows()) ask(first_ + r + kRowsAhead);
    return part_.row(first_ + r).seen[w];
  }
  OBBY_LANES auto cursor(size_t r, size_t) const { return Cursor{values_[r]}; }
  OBBY_LANES void end(size_t r, const Cursor& cursor) { values_[r] = cursor.at; }
  OBBY_LANES float value(size_t r, size_t, int) { return *values_[r]++; }

 private:
  void ask(size_t i) const {
    const char* const begin = reinterpret_cast<const char*>(&part_.row(i));
    for (int line = 0; line < kAskedLines; ++line) __builtin_prefetch(begin + 64 * line);
  }

  const SeenPart& part_;
  size_t first_, count_;
  const float* values_[nn::kRowBlock];  // the next value of each row
};

void SeenPart::fillFirstLayer(const nn::Network<float>& net, float* out) const {
  for (size_t first = 0; first < rows(); first += nn::kRowBlock) {
    Block block(*this, first);
    nn::multiplyUnits<kUnits>(block, block.count(), kInputs, net.weights(0), kWidth,
                              voidSums_.data(), out + first * kUnits,
                              [](size_t, Units& sums) OBBY_INLINED { sums.rectify(); });
  }
}

void SeenPart::addFirstGradient(const nn::Network<float>& net, const float* gradient,
                                std::vector<float>& sums) const {
  Units biases(sums.data() + net.biasesAt(0));
  for (size_t r = 0; r < rows(); ++r) biases.add(gradient + r * kUnits);
  biases.put(sums.data() + net.biasesAt(0));
  for (size_t first = 0; first < rows(); first += nn::kRowBlock) {
    Block block(*this, first);
    nn::addGradientUnits<kUnits>(block, block.count(), kInputs, gradient + first * kUnits, kWidth,
                                 sums.data() + net.at(0));
  }
}

}  // namespace obby::train
