// A device at work for a method that learns while it searches. All that it does has the bits of the
// CPU, which goes on alone from the first failure on. For one thread at a time. Host only.
#pragma once

#include <utility>

#include "solve/learned/device_nets.h"
#include "solve/learned/device_players.h"

namespace obby::solve::learned {

class DeviceWork {
 public:
  // As DevicePlayers::open.
  DeviceWork(sim::Device& device, const Problem& problem, const policy::SurroundingsView& around,
             uint32_t most)
      : nets_(device), status_(players_.open(device, problem, around, most)) {}

  bool works() const { return bool(status_); }
  const Status& status() const { return status_; }  // what failed first

  // Gives work(players, nets), a Status, to the device. True: it was done; false: the CPU is to do
  // it, and nothing has changed.
  template <class Work>
  bool tries(Work&& work) {
    if (works()) status_ = work(players_, nets_);
    return works();
  }

 private:
  DevicePlayers players_;
  DeviceNets nets_;
  Status status_;
};

}  // namespace obby::solve::learned
