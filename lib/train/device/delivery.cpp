#include "train/device/delivery.h"

#include <cstring>

namespace obby::train {

namespace {

constexpr size_t kAlignment = 128;  // bytes, of flattened tables

size_t aligned(size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

Result<Delivery> deliver(sim::Device& device, std::span<const TrainingLevel* const> levels,
                         float patience, uint32_t worlds, ThreadPool& pool) {
  const int count = int(levels.size());
  Delivery out;
  out.places.resize(levels.size());
  std::vector<size_t> tables(levels.size()), firsts(levels.size());
  pool.run(count, [&](int i) {
    TrainingView sized = levels[size_t(i)]->view(patience);
    tables[size_t(i)] = aligned(flatten(sized, 0).size());
  });
  size_t bytes = 0;
  for (size_t i = 0; i < levels.size(); ++i) {
    firsts[i] = bytes;
    bytes += tables[i] + aligned(levels[i]->startBodies().size() * worlds * sizeof(sim::RigidBody));
  }
  OBBY_ASSIGN(sim::Memory memory, sim::Memory::of(device, bytes));
  std::vector<std::byte> all(bytes);
  const auto base = reinterpret_cast<uintptr_t>(memory.address());
  pool.run(count, [&](int n) {
    const auto i = size_t(n);
    DevicePlace& place = out.places[i];
    place.on = levels[i]->view(patience);
    const std::vector<std::byte> flat = flatten(place.on, base + firsts[i]);
    std::memcpy(all.data() + firsts[i], flat.data(), flat.size());
    place.bodies =
        reinterpret_cast<sim::RigidBody*>(memory.as<std::byte>() + firsts[i] + tables[i]);
    place.isNew = true;
  });
  if (bytes != 0) OBBY_RETURN_IF_ERROR(device.uploadAside(memory.address(), all.data(), bytes));
  out.memory = std::make_shared<const sim::Memory>(std::move(memory));
  return out;
}

}  // namespace obby::train
