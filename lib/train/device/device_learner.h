// Proximal policy optimisation on a device, the counterpart of Ppo. Rounding differs.
#pragma once

#include "nn/device/device_adam.h"
#include "nn/device/device_pass.h"
#include "nn/device/sums.h"
#include "train/device/device_ranks.h"
#include "train/device/learn_kernels.h"
#include "train/engine.h"

namespace obby::train {

// A batch (train/ppo.h) on a device, with its advantages and returns.
struct DeviceBatch {
  uint32_t ticks = 0, worlds = 0;
  sim::DeviceTable<float> inputs;  // (ticks, worlds, kInputs)
  sim::DeviceTable<policy::Decision> decisions;
  sim::DeviceTable<float> values, rewards, last, advantages, returns;
  sim::DeviceTable<uint8_t> done;

  Status make(sim::Device& device, uint32_t tickCount, uint32_t worldCount);
  uint32_t rows() const { return ticks * worlds; }
};

class DeviceLearner {
 public:
  // The arguments must outlive this object.
  DeviceLearner(const TrainerSettings& settings, sim::Device& device, Ranks& ranks,
                DeviceRanks& direct)
      : settings_(settings), device_(device), ranks_(ranks), direct_(direct) {}

  // Allocates memory. Call it first.
  Status make();
  Status restore(const LearnerState& state);
  Result<LearnerState> state() const;

  // Runs the network. `inputs`: (rows, kInputs), on the device.
  Status forward(const float* inputs, uint32_t rows) {
    return pass_.forward(parameters_.data(), inputs, rows);
  }
  const float* outputs() const { return pass_.outputs(); }  // (rows, kPaddedOutputs)
  DeviceBatch& batch() { return batch_; }
  const ValueScale& values() const { return values_; }

  // Returns the moments of one of the batch's tables, (rows).
  Result<nn::Moments> momentsOf(const float* table);

  Result<Progress> learn(float rate);

 private:
  nn::Minibatches minibatches() const { return {batch_.rows(), settings_.ppo.minibatch}; }
  Status fillAdvantages();
  Status rescaleValues();
  Result<std::vector<nn::Moments>> moments(const float* values, const Shuffle* shuffle);
  Result<std::vector<double>> advantageMoments(const Shuffle& shuffle);
  Status learnMinibatch(const MinibatchArguments& m);
  Status addRanks();

  TrainerSettings settings_;
  sim::Device& device_;
  Ranks& ranks_;
  DeviceRanks& direct_;
  nn::DevicePass pass_{nn::Rounding::fused};
  nn::DeviceAdam adam_;
  DeviceBatch batch_;
  ValueScale values_;
  sim::DeviceTable<float> parameters_, gradient_, rows_, figures_, everywhere_;
  sim::DeviceTable<double> figureChunks_, totals_;  // totals: kFigures sums, then the sum of norms
  sim::DeviceTable<nn::Moments> chunks_, moments_;
};

}  // namespace obby::train
