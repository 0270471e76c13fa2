// Sparse rows of observations, forward and backward. They are compared with the network of the
// search, and with dense rows in double precision.
#include "train/seen_rows.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "nn/drawn.h"
#include "nn/pass.h"
#include "policy/policy.h"

namespace obby::train {
namespace {

constexpr size_t kInputs = policy::kInputs, kOutputs = policy::kPaddedOutputs;

nn::Network<float> someNetwork(uint64_t seed) {
  Random random(seed, 1);
  nn::Network<float> net = policy::trainableNetwork();
  for (float& w : net.parameters()) w = 0.3f * (random.unit() - 0.5f);
  return net;
}

nn::Network<double> asDouble(const nn::Network<float>& net) {
  nn::Network<double> out = policy::trainableNetwork<double>();
  out.parameters().assign(net.parameters().begin(), net.parameters().end());
  return out;
}

// A network and its observations. The observations hold states, and maps in which one height in
// three is not empty.
struct Seen {
  std::vector<float> means, scales;
  std::vector<float> raw;  // (count, kInputs)
  SeenRows rows;
  nn::Network<float> net;
  std::vector<float> begin;

  explicit Seen(uint32_t count, uint64_t seed = 1)
      : means(kInputs), scales(kInputs), raw(count * kInputs), rows(count), net(someNetwork(seed)) {
    Random random(seed, 0);
    for (size_t i = 0; i < means.size(); ++i) {
      means[i] = 2 * random.unit() - 1;
      scales[i] = 0.2f + 4 * random.unit();
    }
    scales[40] = 0;  // hidden
    rows.normaliseBy(means, scales);
    voidSums(rows, net, begin);
    for (size_t r = 0; r < count; ++r) {
      for (size_t i = 0; i < kInputs; ++i) {
        const bool empty = i >= policy::kStateInputs && random.below(3) != 0;
        raw[r * kInputs + i] = empty ? policy::kEmptyInput : 3 * random.unit() - 1.9f;
      }
      rows.take(r, rawOf(r));
    }
  }

  const float* rawOf(size_t row) const { return raw.data() + row * kInputs; }
  SeenPart part(std::span<const uint32_t> which) const { return {rows, which, begin}; }

  std::vector<double> normalised(std::span<const uint32_t> which) const {
    std::vector<double> out;
    for (const uint32_t r : which) {
      for (size_t i = 0; i < kInputs; ++i)
        out.push_back(double(policy::normalised(rawOf(r)[i], means[i], scales[i])));
    }
    return out;
  }

  // The search's network.
  policy::Network network() const {
    policy::Network out;
    std::vector<float>& numbers = out.numbers();
    std::copy(means.begin(), means.end(), numbers.begin());
    std::copy(scales.begin(), scales.end(), numbers.begin() + kInputs);
    EXPECT_EQ(net.parameters().size() + 2 * kInputs, numbers.size());
    std::copy(net.parameters().begin(), net.parameters().end(), numbers.begin() + 2 * kInputs);
    return out;
  }
};

// Returns random rows, some of them twice.
std::vector<uint32_t> someRows(uint32_t count, uint32_t of) {
  Random random(count, 5);
  std::vector<uint32_t> out(count);
  for (uint32_t& r : out) r = random.below(of);
  return out;
}

std::vector<float> someGradients(size_t rows) {
  Random random(rows, 6);
  std::vector<float> out(rows * kOutputs);
  for (float& g : out) g = random.below(3) == 0 ? 0 : random.unit() - 0.5f;
  return out;
}

// Training and the search compute the same outputs, bit for bit.
TEST(SeenPart, OutputsEqualThoseOfTheSearch) {
  const Seen seen(100);
  const policy::Network network = seen.network();
  const policy::Thinker thinker(network);
  const std::vector<uint32_t> which = someRows(150, 100);
  nn::Pass<float> pass;
  const float* out = pass.forward(seen.net, seen.part(which));
  float largest = 0;
  for (size_t r = 0; r < which.size(); ++r, out += kOutputs) {
    float expected[kOutputs];
    policy::think(thinker.view(), seen.rawOf(which[r]), expected);
    for (size_t m = 0; m < kOutputs; ++m) ASSERT_EQ(out[m], expected[m]) << r;
    largest = std::max(largest, std::abs(out[0]));
  }
  EXPECT_GT(largest, 0.1f);
}

class SeenPartOf : public testing::TestWithParam<uint32_t> {};

// The sizes: one row, less than a block, a block, more than a block, several blocks.
INSTANTIATE_TEST_SUITE_P(SeenPart, SeenPartOf, testing::Values(1, 7, 64, 65, 200));

TEST_P(SeenPartOf, OutputsAndGradientsEqualThoseOfDenseRows) {
  const Seen seen(100, 2);
  const std::vector<uint32_t> which = someRows(GetParam(), 100);
  const std::vector<double> full = seen.normalised(which);
  const std::vector<float> gradient = someGradients(which.size());
  nn::Pass<float> pass;
  std::vector<float> sums(seen.net.parameters().size());
  const float* const out = pass.forward(seen.net, seen.part(which));
  pass.backward(seen.net, seen.part(which), gradient.data(), sums);
  addVoidGradients(seen.rows, seen.net, sums);

  const nn::Network<double> net = asDouble(seen.net);
  const nn::DenseRows<double> rows{full.data(), which.size()};
  nn::Pass<double> exact;
  std::vector<double> expected(sums.size());
  const double* const expectedOut = exact.forward(net, rows);
  for (size_t i = 0; i < which.size() * kOutputs; ++i)
    ASSERT_NEAR(double(out[i]), expectedOut[i], 2e-5) << i;
  const std::vector<double> doubles(gradient.begin(), gradient.end());
  exact.backward(net, rows, doubles.data(), expected);
  for (size_t l = 0; l < net.layers(); ++l) {
    const size_t weights = net.at(l), biases = net.biasesAt(l);
    for (const auto& [at, count] :
         {std::pair(weights, biases - weights), std::pair(biases, net.outputs(l))}) {
      std::vector<double> found(sums.begin() + ptrdiff_t(at), sums.begin() + ptrdiff_t(at + count));
      nn::expectNear(found.data(), expected.data() + at, count, 1e-5, "gradient");
    }
  }
}

// The gradients of two parts add up to those of both, even if a pass had more rows before.
TEST(SeenPart, GradientsAddUp) {
  const Seen seen(100, 5);
  const std::vector<uint32_t> all = someRows(100, 100);
  nn::Pass<float> pass;
  const auto addGradient = [&](std::span<const uint32_t> which, std::vector<float>& sums) {
    const SeenPart part = seen.part(which);
    const float* const out = pass.forward(seen.net, part);
    const std::vector<float> gradient(out, out + which.size() * kOutputs);
    pass.backward(seen.net, part, gradient.data(), sums);
  };
  std::vector<float> whole(seen.net.parameters().size()), parts = whole;
  addGradient(all, whole);
  addGradient(std::span(all).first(33), parts);
  addGradient(std::span(all).subspan(33), parts);
  float largest = 0;
  for (size_t i = 0; i < whole.size(); ++i) {
    ASSERT_NEAR(whole[i], parts[i], 1e-4f) << i;
    largest = std::max(largest, std::abs(whole[i]));
  }
  EXPECT_GT(largest, 0.1f);
}

TEST(SeenRows, AReusedRowStartsEmpty) {
  Seen seen(2);
  seen.rows.take(0, seen.rawOf(1));
  const std::vector<uint32_t> both = {0, 1};
  nn::Pass<float> pass;
  const float* const out = pass.forward(seen.net, seen.part(both));
  for (size_t m = 0; m < kOutputs; ++m) EXPECT_EQ(out[m], out[kOutputs + m]);
}

}  // namespace
}  // namespace obby::train
