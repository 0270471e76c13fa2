#include "train/seen_rows.h"

#include <algorithm>

#include "math/bits.h"
#include "simd/wide.h"

namespace obby::train {

namespace {

constexpr int kUnits = policy::kHidden;
constexpr int kGroups = kUnits / kLanes;
constexpr size_t kAhead = 8;    // rows that are asked for before they are read
constexpr int kAskedLines = 8;  // of cache: what is likely to be read of a row
const float kEmpty = policy::scaledHeight(policy::kDeepest);
static_assert(policy::kInputs % kLanes == 0 && kUnits % kLanes == 0);

struct Units {
  WideFloat group[kGroups];

  OBBY_LANES explicit Units(const float* from) {
    for (int g = 0; g < kGroups; ++g) group[g] = load(from + g * kLanes);
  }
  OBBY_LANES void add(const float* row, WideFloat times) {
    for (int g = 0; g < kGroups; ++g) group[g] = group[g] + load(row + g * kLanes) * times;
  }
  OBBY_LANES void rectify() {
    for (WideFloat& g : group) g = maxf(g, WideFloat(0.0f));
  }
  OBBY_LANES void put(float* to) const {
    for (int g = 0; g < kGroups; ++g) store(group[g], to + g * kLanes);
  }
};

// Calls visit(number of the bit) from the lowest on.
template <class Visit>
OBBY_LANES void forBits(uint64_t bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(lowestBit(bits));
}

// Bit j of word i becomes bit i of word j: blocks of 32, 16, ... 1 change sides.
void transpose(uint64_t words[64]) {
  uint64_t mask = 0xffffffffu;
  for (int size = 32; size != 0; size /= 2, mask ^= mask << size) {
    for (int i = 0; i < 64; i = (i + size + 1) & ~size) {
      const uint64_t swap = (words[i] >> size ^ words[i + size]) & mask;
      words[i] ^= swap << size;
      words[i + size] ^= swap;
    }
  }
}

}  // namespace

void SeenRows::normaliseBy(std::span<const float> means, std::span<const float> scales) {
  means_.assign(means.begin(), means.end());
  scales_.assign(scales.begin(), scales.end());
  for (int i = policy::kStateInputs; i < policy::kInputs; ++i)
    voids_(i) = policy::normalised(kEmpty, means_[size_t(i)], scales_[size_t(i)]);
}

// The player's state is kept whatever it is.
void SeenRows::take(size_t row, const float* raw) {
  Row& to = rows_[row];
  std::fill_n(to.seen, kWords, uint64_t(0));
  to.seen[0] = (uint64_t(1) << policy::kStateInputs) - 1;
  for (int i = 0; i < policy::kInputs; i += kLanes)
    to.seen[i / kBits] |= uint64_t(bitsOf(load(raw + i) != WideFloat(kEmpty))) << i % kBits;
  float shown[policy::kInputs];
  for (int i = 0; i < policy::kInputs; ++i)
    shown[i] = policy::normalised(raw[i], means_[size_t(i)], scales_[size_t(i)]) - voids_(i);
  float* value = to.values;
  for (int w = 0; w < kWords; ++w)
    forBits(to.seen[w], [&](int bit) OBBY_INLINED { *value++ = shown[w * kBits + bit]; });
}

void SeenRows::expand(size_t row, float* out) const {
  std::copy_n(voids_.data(), policy::kInputs, out);
  const float* value = rows_[row].values;
  for (int w = 0; w < kWords; ++w)
    forBits(rows_[row].seen[w], [&](int bit) { out[w * kBits + bit] += *value++; });
}

Line<float> voidSums(const SeenRows& rows, const Weights<float>& net) {
  return net.b[0] + rows.voids() * net.w[0];
}

void addVoidSlopes(const SeenRows& rows, Weights<float>& sums) {
  sums.w[0].noalias() += rows.voids().transpose() * sums.b[0];
}

void SeenPart::ask(size_t i) const {
  const char* const begin = reinterpret_cast<const char*>(&row(i));
  for (int line = 0; line < kAskedLines; ++line) __builtin_prefetch(begin + 64 * line);
}

void SeenPart::firstLayer(const Weights<float>& net, Rows<float>& out) const {
  out.resize(Eigen::Index(which_.size()), kUnits);
  for (size_t first = 0; first < which_.size(); first += kBlock) {
    const size_t count = std::min(kBlock, which_.size() - first);
    blockLayer(first, count, net.w[0].data(), out.data() + first * kUnits);
  }
}

// A word of inputs after the other: its weights stay in a core's nearest cache while all rows pass.
void SeenPart::blockLayer(size_t first, size_t count, const float* weights, float* out) const {
  const float* values[kBlock];
  for (size_t i = 0; i < count; ++i) values[i] = row(first + i).values;
  for (int w = 0; w < SeenRows::kWords; ++w, weights += SeenRows::kBits * kUnits) {
    for (size_t i = 0; i < count; ++i) {
      if (w == 0 && first + i + kAhead < which_.size()) ask(first + i + kAhead);
      Units sums(w == 0 ? voidSums_.data() : out + i * kUnits);
      const float* value = values[i];
      forBits(row(first + i).seen[w],
              [&](int bit) OBBY_INLINED { sums.add(weights + bit * kUnits, WideFloat(*value++)); });
      values[i] = value;
      if (w + 1 == SeenRows::kWords) sums.rectify();
      sums.put(out + i * kUnits);
    }
  }
}

void SeenPart::addFirstSlopes(const Rows<float>& slope, Weights<float>& sums) const {
  for (size_t first = 0; first < which_.size(); first += kBlock) {
    const size_t count = std::min(kBlock, which_.size() - first);
    addBlockSlopes(first, count, slope.data() + first * kUnits, sums.w[0].data());
  }
}

// An input after the other: the slopes of its weights are summed in registers over all rows that
// see it.
void SeenPart::addBlockSlopes(size_t first, size_t count, const float* slope, float* sums) const {
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
              [&](int i) OBBY_INLINED { sum.add(slope + i * kUnits, WideFloat(*values[i]++)); });
      sum.put(sums);
    }
  }
}

}  // namespace obby::train
