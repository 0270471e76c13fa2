// Levels made ahead, on threads of their own, and brought to a device while it plays others.
#pragma once

#include <exception>
#include <thread>
#include <vector>

#include "train/device/delivery.h"
#include "train/env_group.h"

namespace obby::train {

// A level that is ready to be played.
struct NextLevel {
  std::shared_ptr<const TrainingLevel> level;
  DevicePlace place;
  std::shared_ptr<const sim::Memory> memory;  // where it is, with others
  Status said;                                // by the source: without a level, why
};

class NextLevels {
 public:
  struct Wanted {
    size_t place;
    uint64_t index;
    float hardest;
  };

  // Source and device must outlive it.
  NextLevels(const LevelSource& source, const EnvGroupSettings& settings, sim::Device& device,
             size_t places, int threads)
      : source_(source), settings_(settings), device_(device), next_(places), pool_(threads) {}
  ~NextLevels() {
    source_.end();  // what is made ahead may wait for a stream that sends nothing
    wait();
  }
  NextLevels(const NextLevels&) = delete;
  NextLevels& operator=(const NextLevels&) = delete;

  // Begins to make them, one a place; returns at once, when those that were asked for are made.
  void ask(std::vector<Wanted> wanted);
  // That of a place, once all are made; without a level if the source was told to stop, or had an
  // error. The error is the device's. Throws what making them threw.
  Result<NextLevel> take(size_t place);

 private:
  void wait() {
    if (maker_.joinable()) maker_.join();
  }
  void make();
  void makeAll();
  Status bring();

  const LevelSource& source_;
  EnvGroupSettings settings_;
  sim::Device& device_;
  std::vector<Wanted> wanted_;
  std::vector<NextLevel> next_;  // (places)
  Status brought_;
  std::exception_ptr thrown_;  // by the thread that made them, where nobody could catch it
  ThreadPool pool_;
  std::thread maker_;
};

}  // namespace obby::train
