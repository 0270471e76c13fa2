// Proximal policy optimisation on a device: what Ppo is on the CPU.
#pragma once

#include "train/device/device_network.h"
#include "train/device/device_ranks.h"
#include "train/device/learn_kernels.h"
#include "train/engine.h"
#include "train/parts.h"

namespace obby::train {

// A batch (train/ppo.h) on a device, and what is learned from it.
struct DeviceBatch {
  uint32_t ticks = 0, worlds = 0;
  DeviceTable<float> inputs;  // (ticks, worlds, kInputs)
  DeviceTable<policy::Decision> decisions;
  DeviceTable<float> values, rewards, last, advantages, targets;
  DeviceTable<uint8_t> done;

  Status make(sim::Device& device, uint32_t tickCount, uint32_t worldCount);
  uint32_t rows() const { return ticks * worlds; }
};

class DeviceLearner {
 public:
  // What it refers to must outlive it.
  DeviceLearner(const TrainerSettings& settings, sim::Device& device, Ranks& ranks,
                DeviceRanks& direct)
      : settings_(settings), device_(device), ranks_(ranks), direct_(direct) {}

  // To be called first.
  Status make();
  Status restore(const LearnerState& state);
  Result<LearnerState> state() const;

  DeviceNetwork& network() { return network_; }
  DeviceBatch& batch() { return batch_; }
  const ValueScale& values() const { return values_; }

  // Sums of one of the batch's tables, (rows).
  Result<Moments> momentsOf(const float* table);

  Result<Progress> learn(float rate);

 private:
  Parts partsOfPass() const { return {batch_.rows(), settings_.ppo.part}; }
  Status fillAdvantages();
  Status rescaleValues();
  Result<std::vector<AdvantageScale>> scalesOf(const Shuffle& shuffle);
  Result<std::vector<Moments>> moments(const MomentArguments& m);
  Status learnPart(const PartArguments& part, const AdvantageScale& scale, float rate);
  Status addRanks();
  Status step(float decisions, float rate);

  TrainerSettings settings_;
  sim::Device& device_;
  Ranks& ranks_;
  DeviceRanks& direct_;
  DeviceNetwork network_;
  DeviceBatch batch_;
  policy::Adam adam_;
  ValueScale values_;
  DeviceTable<float> momentum_, squares_, rows_, figures_, scale_, everywhere_;
  DeviceTable<double> figureChunks_, totals_;  // totals: kFigures sums, then that of norms
  DeviceTable<Moments> chunks_, parts_, squareChunks_;
};

}  // namespace obby::train
