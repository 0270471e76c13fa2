#include "solve/device_rollouts.h"

#include "solve/cuda/cuda.h"

namespace obby::solve {

namespace {

// The context and the cells' clock lie together on the device.
struct Tables {
  ExploreContext context;
  ClockView clock;
};

template <class Table>
void forTables(Tables& t, Table&& table) {
  forTables(t.context, table);
  forTables(t.clock, table);
}

template <class T>
Status grow(sim::Device& device, sim::Memory& memory, size_t count) {
  if (memory.bytes() >= count * sizeof(T)) return {};
  OBBY_ASSIGN(memory, sim::Memory::of(device, count * sizeof(T)));
  return {};
}

template <class T>
Status fetch(sim::Device& device, std::vector<T>& to, const T* from) {
  if (to.empty()) return {};
  return device.download(to.data(), from, to.size() * sizeof(T));
}

}  // namespace

Result<DeviceRollouts> DeviceRollouts::open(sim::Device& device, RolloutArguments arguments) {
  Tables tables{arguments.context, arguments.binning.clock};
  OBBY_ASSIGN(sim::Memory memory, sim::uploadTables(device, tables));
  arguments.context = tables.context;
  arguments.binning.clock = tables.clock;
  arguments.room = visitRoom(arguments);
  DeviceRollouts rollouts(device, arguments);
  rollouts.tables_ = std::move(memory);
  return rollouts;
}

Status DeviceRollouts::makeRoom(size_t rollouts) {
  OBBY_RETURN_IF_ERROR(grow<RolloutVisit>(*device_, visitMemory_, rollouts * arguments_.room));
  OBBY_RETURN_IF_ERROR(grow<RolloutEnd>(*device_, endMemory_, rollouts));
  const size_t bodies = arguments_.context.level.looseCount;
  OBBY_RETURN_IF_ERROR(
      grow<sim::LooseBody>(*device_, visitLooseMemory_, rollouts * arguments_.room * bodies));
  endLoose_.resize(rollouts * bodies);
  visitLoose_.resize(rollouts * arguments_.room * bodies);
  arguments_.loose = looseMemory_.as<sim::LooseBody>();
  arguments_.visitLoose = visitLooseMemory_.as<sim::LooseBody>();
  ends_.resize(rollouts);
  visits_.resize(rollouts * arguments_.room);
  arguments_.starts = startMemory_.as<RolloutStart>();
  arguments_.visits = visitMemory_.as<RolloutVisit>();
  arguments_.ends = endMemory_.as<RolloutEnd>();
  return {};
}

Status DeviceRollouts::run(std::span<const RolloutStart> starts,
                           std::span<const sim::LooseBody> loose) {
  OBBY_RETURN_IF_ERROR(sim::uploadTable(*device_, startMemory_, starts));
  OBBY_RETURN_IF_ERROR(sim::uploadTable(*device_, looseMemory_, loose));
  OBBY_RETURN_IF_ERROR(makeRoom(starts.size()));
  OBBY_RETURN_IF_ERROR(device_->launch(rolloutKernel(arguments_.context.level.looseCount != 0),
                                       &arguments_, uint32_t(starts.size())));
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
