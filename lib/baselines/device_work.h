// A device as an accelerator for a learned method. Results have the same bits as the CPU's, which
// does all work after the first failure. For one thread at a time. Host only.
#pragma once

#include <utility>

#include "baselines/device_nets.h"
#include "baselines/device_players.h"
#include "baselines/names.h"

namespace obby::baselines {

class DeviceWork {
 public:
  // See DevicePlayers::open.
  DeviceWork(sim::Device& device, const Problem& problem, const policy::SurroundingsView& around,
             uint32_t max)
      : nets_(device), status_(players_.open(device, problem, around, max)) {}

  bool works() const { return bool(status_); }
  const Status& status() const { return status_; }  // the first failure

  // Runs work(players, nets), which returns a Status, on the device. Returns false if the CPU has
  // to do the work; then nothing has changed.
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

}  // namespace obby::baselines
