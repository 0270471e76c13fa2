#include "solve/search/rollouts/device_rollouts.h"

#include "solve/search/cuda/cuda.h"

namespace obby::solve {

namespace {

template <class T>
Status fetch(sim::Device& device, std::vector<T>& to, const T* from) {
  if (to.empty()) return {};
  return device.download(to.data(), from, to.size() * sizeof(T));
}

}  // namespace

Result<DeviceRollouts> DeviceRollouts::open(sim::Device& device, const RolloutRules& rules) {
  DeviceRollouts rollouts(device, rules);
  OBBY_ASSIGN(rollouts.tables_, sim::uploadTables(device, rollouts.arguments_.rules));
  return rollouts;
}

Status DeviceRollouts::makeRoom(size_t rollouts) {
  RolloutArguments& a = arguments_;
  const size_t bodies = a.rules.context.level.looseCount, visits = rollouts * a.room;
  OBBY_RETURN_IF_ERROR(sim::makeRoom(*device_, visitMemory_, a.visits, visits));
  OBBY_RETURN_IF_ERROR(sim::makeRoom(*device_, visitLooseMemory_, a.visitLoose, visits * bodies));
  OBBY_RETURN_IF_ERROR(sim::makeRoom(*device_, endMemory_, a.ends, rollouts));
  endLoose_.resize(rollouts * bodies);
  visitLoose_.resize(visits * bodies);
  ends_.resize(rollouts);
  visits_.resize(visits);
  a.starts = startMemory_.as<RolloutStart>();
  a.loose = looseMemory_.as<sim::LooseBody>();
  return {};
}

Status DeviceRollouts::run(std::span<const RolloutStart> starts,
                           std::span<const sim::LooseBody> loose) {
  OBBY_RETURN_IF_ERROR(sim::uploadTable(*device_, startMemory_, starts));
  OBBY_RETURN_IF_ERROR(sim::uploadTable(*device_, looseMemory_, loose));
  OBBY_RETURN_IF_ERROR(makeRoom(starts.size()));
  OBBY_RETURN_IF_ERROR(
      device_->launch(rolloutKernel(arguments_.rules.context.level.looseCount != 0), &arguments_,
                      uint32_t(starts.size())));
  OBBY_RETURN_IF_ERROR(fetch(*device_, ends_, arguments_.ends));
  OBBY_RETURN_IF_ERROR(fetch(*device_, endLoose_, arguments_.loose));
  OBBY_RETURN_IF_ERROR(fetch(*device_, visitLoose_, arguments_.visitLoose));
  return fetch(*device_, visits_, arguments_.visits);
}

namespace {

template <bool kLoose>
const sim::Kernel& kernelOf(const char* name) {
  static const sim::Kernel kernel{name, sim::kernelBody<RolloutArguments, exploreOne<kLoose>>,
                                  cuda::rolloutEntry(kLoose), sizeof(RolloutArguments)};
  return kernel;
}

}  // namespace

const sim::Kernel& rolloutKernel(bool loose) {
  return loose ? kernelOf<true>("rolloutLoose") : kernelOf<false>("rollout");
}

}  // namespace obby::solve
