// The network's kernels against Eigen: outputs, gradients, sums.
#include "train/device/device_network.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/host_device.h"
#include "train/device/sums.h"
#include "train/full_pass.h"

namespace obby::train {
namespace {

template <class Numbers>
void fill(Numbers& numbers, Random& random, float scale) {
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
    numbers.data()[i] = scale * (random.unit() - 0.5f);
}

// Of numbers that are sums of many, relative to the largest.
void expectNear(const std::vector<float>& found, const float* expected, const char* what) {
  float largest = 0;
  for (size_t i = 0; i < found.size(); ++i) largest = std::max(largest, std::abs(expected[i]));
  ASSERT_GT(largest, 0) << what;
  for (size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], expected[i], 2e-6f * largest) << what << " " << i;
}

class OfRows : public testing::TestWithParam<uint32_t> {};

// One row, less than a tile, not a multiple of it, several chunks.
INSTANTIATE_TEST_SUITE_P(DeviceNetwork, OfRows, testing::Values(1, 7, 8, 255, 256, 700));

TEST_P(OfRows, HasTheOutputsAndGradientsOfEigen) {
  const uint32_t rows = GetParam();
  Random random(5, rows);
  Weights<float> weights, gradient;
  weights.blocks([&](float* w, size_t count) {
    for (size_t i = 0; i < count; ++i) w[i] = 0.3f * (random.unit() - 0.5f);
  });
  Rows<float> inputs(rows, policy::kInputs), slopes(rows, policy::kPaddedOutputs);
  fill(inputs, random, 2);
  fill(slopes, random, 1);
  FullPass<float> pass;
  const Rows<float>& outputs = pass.forward(weights, inputs);
  pass.backward(weights, inputs, slopes, gradient);

  ThreadPool pool(2);
  sim::HostDevice device(pool);
  DeviceNetwork network;
  ASSERT_TRUE(network.make(device, 700, 700));
  ASSERT_TRUE(network.put(weights));
  EXPECT_EQ(network.get()->flat(), weights.flat());
  DeviceTable<float> in;
  ASSERT_TRUE(in.make(device, size_t(inputs.size())));
  ASSERT_TRUE(in.put({inputs.data(), size_t(inputs.size())}));
  ASSERT_TRUE(network.forward(in.data(), rows));
  const auto found =
      sim::downloadTable(device, network.outputs(), size_t(rows) * policy::kPaddedOutputs);
  expectNear(*found, outputs.data(), "outputs");
  ASSERT_TRUE(
      device.upload(network.slopes(), slopes.data(), size_t(slopes.size()) * sizeof(float)));
  ASSERT_TRUE(network.backward(in.data(), rows));
  const auto learned = sim::downloadTable(device, network.gradient(), network.size());
  size_t at = 0;
  gradient.blocks([&](const float* g, size_t count) {
    expectNear({learned->begin() + ptrdiff_t(at), learned->begin() + ptrdiff_t(at + count)}, g,
               "gradient");
    at += count;
  });
}

// Whichever way the CPU in a GPU's place multiplies and adds (kernels.cpp), it is in one step.
TEST(DeviceProducts, AreFusedWhateverTheBuild) {
  Random random(7, 7);
  Rows<float> a(16, 24), b(24, 8), c(16, 8), out(16, 8), sums(24, 8);
  fill(a, random, 2);
  fill(b, random, 2);
  fill(c, random, 2);
  const ProductArguments product{a.data(), b.data(), nullptr, nullptr, out.data(),
                                 16,       24,       8,       false};
  for (uint32_t i = 0; i < productTiles(product); ++i)
    trainKernel(TrainStep::product).body(&product, i);
  const GradientArguments gradient{a.data(), c.data(), sums.data(), 16, 24, 8};
  for (uint32_t i = 0; i < gradientTiles(gradient); ++i)
    trainKernel(TrainStep::gradient).body(&gradient, i);
  const auto fused = [](const Rows<float>& x, const Rows<float>& y, Eigen::Index r,
                        Eigen::Index col) {
    float sum = 0;
    for (Eigen::Index k = 0; k < x.cols(); ++k) sum = std::fma(x(r, k), y(k, col), sum);
    return sum;
  };
  const Rows<float> turned = a.transpose();
  int rounded = 0;
  for (Eigen::Index col = 0; col < 8; ++col) {
    for (Eigen::Index r = 0; r < 16; ++r) {
      ASSERT_EQ(out(r, col), fused(a, b, r, col));
      float apart = 0;
      for (Eigen::Index k = 0; k < a.cols(); ++k) apart += a(r, k) * b(k, col);
      rounded += apart != out(r, col);
    }
    for (Eigen::Index r = 0; r < 24; ++r) ASSERT_EQ(sums(r, col), fused(turned, c, r, col));
  }
  EXPECT_GT(rounded, 10) << "two steps would do";
}

TEST(DeviceSums, AreThoseOfPartsShuffledOrNot) {
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  constexpr uint32_t kCount = 3 * 512 + 1;  // the first part has a chunk more than the others
  const Parts cut(kCount, 600);
  ASSERT_EQ(cut.count(), 3u);
  ASSERT_GT(chunksOf(cut.size(0)), chunksOf(cut.size(1)));
  Random random(6, 6);
  std::vector<float> values(kCount);
  for (float& v : values) v = random.unit();
  DeviceTable<float> there;
  DeviceTable<Moments> chunks, parts;
  ASSERT_TRUE(there.make(device, kCount));
  ASSERT_TRUE(there.put(values));
  ASSERT_TRUE(chunks.make(device, 3 * chunksOf(cut.largest())));
  ASSERT_TRUE(parts.make(device, 3));
  for (const bool shuffled : {false, true}) {
    const MomentArguments m{there.data(),          chunks.data(), parts.data(),
                            Shuffle(1, 2, kCount), shuffled,      cut};
    ASSERT_TRUE(enqueue(device, TrainStep::chunkMoments, m, 3 * m.chunksOfEach()));
    ASSERT_TRUE(enqueue(device, TrainStep::partMoments, m, 3));
    const auto found = parts.get();
    for (uint32_t part = 0; part < 3; ++part) {
      double sum = 0, squares = 0;
      for (uint32_t i = cut.first(part); i < cut.first(part) + cut.size(part); ++i) {
        const double v = double(values[shuffled ? m.shuffle(i) : i]);
        sum += v;
        squares += v * v;
      }
      EXPECT_NEAR((*found)[part].sum, sum, 1e-9) << part;
      EXPECT_NEAR((*found)[part].squares, squares, 1e-9) << part;
    }
  }
}

TEST(DeviceSums, OfRowsRunFromTheFirstToTheLast) {
  const sim::Kernel& kernel = trainKernel(TrainStep::sumRows);
  const float floats[] = {1e8f, -0.0f, 1, -0.0f, -1e8f, -0.0f};  // (3, 2)
  float out[2] = {7, 7};
  const RowSumArguments toFloats{floats, nullptr, out, nullptr, 3, 2};
  for (uint32_t i = 0; i < 2; ++i) kernel.body(&toFloats, i);
  EXPECT_EQ(out[0], 0.0f) << "in another order it is 1";
  EXPECT_TRUE(std::signbit(out[1])) << "nothing is added to what is there";
  const double doubles[] = {1e16, 2, 1, 3, -1e16, 4};
  double added[2] = {1, 1};
  const RowSumArguments toDoubles{nullptr, doubles, out, added, 3, 2};
  for (uint32_t i = 0; i < 2; ++i) kernel.body(&toDoubles, i);
  EXPECT_EQ(out[0], 0.0f);
  EXPECT_EQ(out[1], 9.0f);
  EXPECT_EQ(added[0], 1.0);
  EXPECT_EQ(added[1], 10.0);
}

}  // namespace
}  // namespace obby::train
