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

Status DeviceRollouts::reserve(size_t rollouts) {
  RolloutArguments& a = arguments_;
  const size_t bodyCount = a.rules.context.level.bodyCount, visits = rollouts * a.capacity;
  OBBY_RETURN_IF_ERROR(sim::reserve(*device_, visitMemory_, a.visits, visits));
  OBBY_RETURN_IF_ERROR(sim::reserve(*device_, visitBodyMemory_, a.visitBodies, visits * bodyCount));
  OBBY_RETURN_IF_ERROR(sim::reserve(*device_, endMemory_, a.ends, rollouts));
  endBodies_.resize(rollouts * bodyCount);
  visitBodies_.resize(visits * bodyCount);
  ends_.resize(rollouts);
  visits_.resize(visits);
  a.starts = startMemory_.as<RolloutStart>();
  a.bodies = bodyMemory_.as<sim::RigidBody>();
  return {};
}

Status DeviceRollouts::run(std::span<const RolloutStart> starts,
                           std::span<const sim::RigidBody> bodies) {
  OBBY_RETURN_IF_ERROR(sim::uploadTable(*device_, startMemory_, starts));
  OBBY_RETURN_IF_ERROR(sim::uploadTable(*device_, bodyMemory_, bodies));
  OBBY_RETURN_IF_ERROR(reserve(starts.size()));
  OBBY_RETURN_IF_ERROR(device_->launch(rolloutKernel(arguments_.rules.context.level.bodyCount != 0),
                                       &arguments_, uint32_t(starts.size())));
  OBBY_RETURN_IF_ERROR(fetch(*device_, ends_, arguments_.ends));
  OBBY_RETURN_IF_ERROR(fetch(*device_, endBodies_, arguments_.bodies));
  OBBY_RETURN_IF_ERROR(fetch(*device_, visitBodies_, arguments_.visitBodies));
  return fetch(*device_, visits_, arguments_.visits);
}

namespace {

template <bool kDynamic>
const sim::Kernel& kernelOf(const char* name) {
  static const sim::Kernel kernel{name, sim::kernelBody<RolloutArguments, exploreOne<kDynamic>>,
                                  cuda::rolloutEntry(kDynamic), sizeof(RolloutArguments)};
  return kernel;
}

}  // namespace

const sim::Kernel& rolloutKernel(bool bodies) {
  return bodies ? kernelOf<true>("rolloutLoose") : kernelOf<false>("rollout");
}

}  // namespace obby::solve
