// Kernels of networks give the outputs, gradients and sums of the CPU.
#include "nn/device/device_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn.h"
#include "nn/device/sums.h"
#include "nn/pass.h"
#include "sim/host_device.h"

namespace obby::nn {
namespace {

// A network with its inputs and output gradients. The results of the CPU and of a device are
// compared.
struct Rows {
  explicit Rows(uint32_t count) : rows(count), random(5, count), net({32, 64, 64, 48}) {
    for (float& w : net.parameters()) w = 0.3f * (random.unit() - 0.5f);
    inputs = drawn<float>(rows * 32, random);
    outGradient = drawn<float>(rows * 48, random);
    sums.resize(net.parameters().size());
    inputGradient.resize(inputs.size());
    const DenseRows<float> in{inputs.data(), rows};
    outputs = pass.forward(net, in);
    pass.backward(net, in, outGradient.data(), sums, inputGradient.data());
  }

  // Runs the network on a device and fills the fields found*.
  void on(sim::Device& device, Rounding rounding) {
    DevicePass there(rounding);
    sim::DeviceTable<float> parameters, in, gradient, below;
    for (auto& [table, numbers] : {std::pair(&parameters, &std::as_const(net).parameters()),
                                   std::pair(&in, &std::as_const(inputs))}) {
      ASSERT_TRUE(table->make(device, numbers->size()));
      ASSERT_TRUE(table->put(*numbers));
    }
    ASSERT_TRUE(gradient.make(device, sums.size()));
    ASSERT_TRUE(below.make(device, inputs.size()));
    ASSERT_TRUE(there.reserve(device, net, 700, 700));
    ASSERT_TRUE(there.forward(parameters.data(), in.data(), rows));
    foundOutputs = *sim::downloadTable(device, there.outputs(), size_t(rows) * 48);
    ASSERT_TRUE(device.upload(there.outputGradient(), outGradient.data(),
                              outGradient.size() * sizeof(float)));
    ASSERT_TRUE(there.backward(parameters.data(), in.data(), rows, gradient.data(), below.data()));
    foundSums = *gradient.get();
    foundBelow = *below.get();
  }

  uint32_t rows;
  Random random;
  Network<float> net;
  std::vector<float> inputs, outGradient, sums, inputGradient;
  Pass<float> pass;
  const float* outputs;
  std::vector<float> foundOutputs, foundSums, foundBelow;
};

class OfRows : public testing::TestWithParam<uint32_t> {};

// The sizes: one row, less than a tile, a tile, less than a chunk, a chunk, several chunks.
INSTANTIATE_TEST_SUITE_P(DevicePass, OfRows, testing::Values(1, 7, 8, 255, 256, 700));

TEST_P(OfRows, MatchesTheOutputsAndGradientsOfTheCpu) {
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  Rows r(GetParam());
  r.on(device, Rounding::fused);
  expectNear(r.foundOutputs.data(), r.outputs, r.foundOutputs.size(), 2e-6, "outputs");
  expectNear(r.foundSums.data(), r.sums.data(), r.sums.size(), 2e-6, "gradient");
  expectNear(r.foundBelow.data(), r.inputGradient.data(), r.inputs.size(), 2e-6, "below");
  r.on(device, Rounding::asCpu);
  EXPECT_EQ(r.foundOutputs, std::vector<float>(r.outputs, r.outputs + r.foundOutputs.size()));
  EXPECT_EQ(r.foundSums, r.sums);
  EXPECT_EQ(r.foundBelow, r.inputGradient);
}

// In every build, the CPU that stands in for the GPU fuses multiply and add if the kernel requests
// it (kernels.cpp).
TEST(DeviceProducts, AreFusedOnRequestInEveryBuild) {
  constexpr size_t kRows = 16, kInner = 24, kColumns = 8;
  Random random(7, 7);
  const auto a = drawn<float>(kRows * kInner, random), b = drawn<float>(kInner * kColumns, random);
  std::vector<float> fused(kRows * kColumns), apart = fused;
  const auto multiply = [&](Step step, std::vector<float>& out, uint32_t tiles) {
    const ProductArguments p{a.data(), b.data(), nullptr,  nullptr, out.data(),
                             kRows,    kInner,   kColumns, false};
    for (uint32_t i = 0; i < tiles; ++i) kernel(step).body(&p, i);
  };
  multiply(Step::product, fused, kRows / 8);
  multiply(Step::productAsCpu, apart, kRows * kColumns);
  int rounded = 0;
  for (size_t r = 0; r < kRows; ++r) {
    for (size_t c = 0; c < kColumns; ++c) {
      float one = 0, two = 0;
      for (size_t k = 0; k < kInner; ++k) {
        const float x = a[r * kInner + k], y = b[k * kColumns + c];
        one = std::fma(x, y, one);
        two += x * y;
      }
      ASSERT_EQ(fused[r * kColumns + c], one);
      ASSERT_EQ(apart[r * kColumns + c], two);
      rounded += one != two;
    }
  }
  EXPECT_GT(rounded, 10) << "the two are the same";
}

TEST(DeviceSums, EqualMinibatchSumsShuffledOrNot) {
  ThreadPool pool(2);
  sim::HostDevice device(pool);
  constexpr uint32_t kCount =
      3 * 512 + 1;  // so that the first minibatch has one chunk more than the others
  const Minibatches cut(kCount, 600);
  ASSERT_EQ(cut.count(), 3u);
  ASSERT_GT(chunksOf(cut.size(0)), chunksOf(cut.size(1)));
  Random random(6, 6);
  std::vector<float> values(kCount);
  for (float& v : values) v = random.unit();
  sim::DeviceTable<float> there;
  sim::DeviceTable<Moments> chunks, found;
  ASSERT_TRUE(there.make(device, kCount));
  ASSERT_TRUE(there.put(values));
  ASSERT_TRUE(chunks.make(device, 3 * chunksOf(cut.largest())));
  ASSERT_TRUE(found.make(device, 3));
  for (const bool shuffled : {false, true}) {
    const MomentArguments m{there.data(),          chunks.data(), found.data(),
                            Shuffle(1, 2, kCount), shuffled,      cut};
    ASSERT_TRUE(enqueue(device, kernel(Step::chunkMoments), m, 3 * m.chunksOfEach()));
    ASSERT_TRUE(enqueue(device, kernel(Step::partMoments), m, 3));
    const auto moments = found.get();
    for (uint32_t n = 0; n < 3; ++n) {
      Moments expected;
      for (uint32_t i = cut.first(n); i < cut.first(n) + cut.size(n); ++i)
        expected.add(double(values[shuffled ? m.shuffle(i) : i]));
      EXPECT_NEAR((*moments)[n].sum, expected.sum, 1e-9) << n;
      EXPECT_NEAR((*moments)[n].squares, expected.squares, 1e-9) << n;
    }
  }
}

TEST(DeviceSums, RowSumsRunFromFirstToLast) {
  const sim::Kernel& sumRows = kernel(Step::sumRows);
  const float floats[] = {1e8f, -0.0f, 1, -0.0f, -1e8f, -0.0f};  // (3, 2)
  float out[2] = {7, 7};
  const RowSumArguments toFloats{floats, nullptr, out, nullptr, 3, 2};
  for (uint32_t i = 0; i < 2; ++i) sumRows.body(&toFloats, i);
  EXPECT_EQ(out[0], 0.0f) << "in another order it is 1";
  EXPECT_TRUE(std::signbit(out[1])) << "nothing is added to what is there";
  const double doubles[] = {1e16, 2, 1, 3, -1e16, 4};
  double added[2] = {1, 1};
  const RowSumArguments toDoubles{nullptr, doubles, out, added, 3, 2};
  for (uint32_t i = 0; i < 2; ++i) sumRows.body(&toDoubles, i);
  EXPECT_EQ(out[0], 0.0f);
  EXPECT_EQ(out[1], 9.0f);
  EXPECT_EQ(added[0], 1.0);
  EXPECT_EQ(added[1], 10.0);
}

}  // namespace
}  // namespace obby::nn
