// Makes levels ahead on other threads and uploads them while a device plays others.
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
  std::shared_ptr<const sim::Memory> memory;  // holds this level among others
  Status said;                                // the source's error if there is no level
};

class NextLevels {
 public:
  struct Wanted {
    size_t place;
    uint64_t index;
    float hardest;
  };

  // Source and device must outlive this object.
  NextLevels(const LevelSource& source, const EnvGroupSettings& settings, sim::Device& device,
             size_t places, int threads)
      : source_(source), settings_(settings), device_(device), next_(places), pool_(threads) {}
  ~NextLevels() {
    source_.end();  // the source may be waiting for a stream that sends nothing
    wait();
  }
  NextLevels(const NextLevels&) = delete;
  NextLevels& operator=(const NextLevels&) = delete;

  // Starts to make the levels, one per place, once the previous request is done. Does not wait.
  void ask(std::vector<Wanted> wanted);
  // Waits for all levels and returns the level of a place. Returns no level if the source was told
  // to stop or had an error. Errors: the device's. Rethrows exceptions of the thread that made
  // them.
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
  std::exception_ptr thrown_;  // exception of the thread that makes levels
  ThreadPool pool_;
  std::thread maker_;
};

}  // namespace obby::train
