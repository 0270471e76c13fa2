// Settings for running a place's scripts: budgets, skips and randomness.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/document.h"

namespace obby::engine {

struct Budget {
  size_t memory = size_t(192) << 20;    // bytes
  uint64_t instructions = 400'000'000;  // budget of all scripts together
  uint64_t stretch = 20'000'000;        // budget between two yields
};

// The distribution of the random numbers that scripts draw. Mostly low or mostly high numbers show
// which effects depend on chance. The few other numbers end loops that wait for them.
enum class Draws : uint8_t { even, low, high };

struct Settings {
  Budget budget;
  std::string rig = "r15";  // body of the players: r6 or r15
  uint64_t seed = 1;        // seed of math.random and other generators
  Draws draws = Draws::even;
  size_t instances = 60'000;            // max instances that scripts may make
  std::vector<InstanceId> skipped;      // scripts that are left out
  InstanceId* runningScript = nullptr;  // kept up to date if not null
};

}  // namespace obby::engine
