#include "solve/search/resident/device_archive.h"

#include <algorithm>

#include "solve/search/resident/round_view.h"
#include "solve/search/resident/steps.h"

namespace obby::solve {

namespace {

constexpr uint32_t kFirstCells = 8192;

template <class T>
Status put(sim::Device& device, T* to, const T& value) {
  return device.upload(to, &value, sizeof value);
}

}  // namespace

DeviceArchive::DeviceArchive(sim::Device& device, uint32_t bodyCount) : device_(&device) {
  view_.bodyCount = bodyCount;
}

Status DeviceArchive::addStart(const Problem& problem, uint64_t key, float potential,
                               uint32_t wait) {
  OBBY_RETURN_IF_ERROR(grow(1));
  sim::Device& d = *device_;
  OBBY_RETURN_IF_ERROR(put(d, view_.slots + (key & view_.slotMask), {key, 0}));
  OBBY_RETURN_IF_ERROR(put(d, view_.worlds, problem.start));
  OBBY_RETURN_IF_ERROR(put(d, view_.ranks, arrivalRank(problem.start)));
  OBBY_RETURN_IF_ERROR(put(d, view_.nodes, 0u));
  OBBY_RETURN_IF_ERROR(put(d, view_.seen, 0u));
  OBBY_RETURN_IF_ERROR(put(d, view_.waits, wait));
  OBBY_RETURN_IF_ERROR(put(d, view_.potentials, potential));
  view_.cellCount = 1;
  const std::vector<sim::RigidBody>& bodies = problem.startBodies;
  if (bodies.empty()) return {};
  return d.upload(view_.bodies, bodies.data(), bodies.size() * sizeof(sim::RigidBody));
}

// Enlarges a table, keeps its contents, and fills the rest with 0.
template <class T>
Status DeviceArchive::widen(sim::Memory& memory, T*& table, size_t count) {
  if (count == 0) return {};
  OBBY_ASSIGN(sim::Memory wider, sim::Memory::of(*device_, count * sizeof(T)));
  const size_t old = memory.bytes();
  if (old != 0) OBBY_RETURN_IF_ERROR(device_->copy(wider.address(), memory.address(), old));
  OBBY_RETURN_IF_ERROR(device_->fill(wider.as<uint8_t>() + old, 0, wider.bytes() - old));
  memory = std::move(wider);
  table = memory.as<T>();
  return {};
}

Status DeviceArchive::growTable(uint32_t slots) {
  const uint32_t old = capacity_ == 0 ? 0 : view_.slotMask + 1;
  OBBY_ASSIGN(sim::Memory wider, sim::Memory::of(*device_, size_t(slots) * sizeof(CellSlot)));
  OBBY_RETURN_IF_ERROR(device_->fill(wider.address(), 0, wider.bytes()));
  view_.slots = wider.as<CellSlot>();
  view_.slotMask = slots - 1;
  const RehashArguments arguments{view_, slots_.as<CellSlot>()};
  OBBY_RETURN_IF_ERROR(device_->launch(residentKernel(ResidentStep::rehash), &arguments, old));
  slots_ = std::move(wider);
  return {};
}

Status DeviceArchive::grow(uint32_t cells) {
  if (cells <= capacity_) return {};
  uint32_t capacity = std::max(capacity_, kFirstCells);
  while (capacity < cells) capacity *= 2;
  OBBY_RETURN_IF_ERROR(growTable(2 * capacity));
  OBBY_RETURN_IF_ERROR(widen(worlds_, view_.worlds, capacity));
  OBBY_RETURN_IF_ERROR(widen(bodies_, view_.bodies, size_t(capacity) * view_.bodyCount));
  OBBY_RETURN_IF_ERROR(widen(ranks_, view_.ranks, capacity));
  OBBY_RETURN_IF_ERROR(widen(nodes_, view_.nodes, capacity));
  OBBY_RETURN_IF_ERROR(widen(seen_, view_.seen, capacity));
  OBBY_RETURN_IF_ERROR(widen(sighted_, view_.sighted, capacity / 32));
  OBBY_RETURN_IF_ERROR(widen(waits_, view_.waits, capacity));
  OBBY_RETURN_IF_ERROR(widen(potentials_, view_.potentials, capacity));
  uint64_t* sums = nullptr;
  const SumTree largest = makeSumTree(nullptr, capacity);
  OBBY_RETURN_IF_ERROR(sim::reserve(*device_, sums_, sums, largest.firsts[largest.levels]));
  OBBY_RETURN_IF_ERROR(sim::reserve(*device_, bestSums_, sums, largest.firsts[largest.levels]));
  capacity_ = capacity;
  return {};
}

}  // namespace obby::solve
