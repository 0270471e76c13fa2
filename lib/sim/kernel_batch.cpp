// A batch on a device that runs kernels. The state stays on the device between steps, and a step of
// several ticks is one launch.
#include "sim/cuda/cuda.h"
#include "sim/first_worlds.h"
#include "sim/simulator.h"
#include "sim/step_kernel.h"

namespace obby::sim {
namespace {

class KernelBatch : public Batch {
 public:
  KernelBatch(uint32_t worlds, uint32_t bodyStride, Device& device)
      : Batch(worlds, bodyStride), device_(device) {}

  Status begin(const Course& course, const FirstWorlds& first) {
    args_.set = course.set();
    OBBY_ASSIGN(tables_, uploadTables(device_, args_.set));
    // A single level is passed as a kernel argument; its tables are in the device's memory.
    args_.count = size();
    if (course.levels.size() == 1) {
      OBBY_RETURN_IF_ERROR(device_.download(&args_.only, args_.set.levels, sizeof args_.only));
    }
    OBBY_RETURN_IF_ERROR(uploadTable<World>(device_, worlds_, first.worlds));
    OBBY_RETURN_IF_ERROR(uploadTable<Episode>(device_, episodes_, first.episodes));
    OBBY_RETURN_IF_ERROR(uploadTable<RigidBody>(device_, bodies_, first.bodies));
    args_.bodies = bodies_.as<RigidBody>();
    args_.worlds = worlds_.as<World>();
    args_.episodes = episodes_.as<Episode>();
    return {};
  }

  Status restore(uint32_t first, std::span<const World> worlds,
                 std::span<const RigidBody> bodies) override {
    OBBY_RETURN_IF_ERROR(
        device_.upload(worlds_.as<World>() + first, worlds.data(), worlds.size_bytes()));
    if (bodies.empty()) return {};
    RigidBody* const to = args_.bodies + size_t(first) * args_.set.bodyStride;
    return device_.upload(to, bodies.data(), bodies.size_bytes());
  }
  Result<std::vector<World>> worlds() const override { return fetch<World>(worlds_, size()); }
  Result<std::vector<RigidBody>> bodies() const override {
    return fetch<RigidBody>(bodies_, size_t(size()) * args_.set.bodyStride);
  }
  Result<std::vector<Episode>> episodes() const override {
    return fetch<Episode>(episodes_, size());
  }

 private:
  StepKind kind() const {
    if (args_.set.bodyStride != 0) return StepKind::bodies;
    return args_.set.levelCount == 1 ? StepKind::oneLevel : StepKind::manyLevels;
  }

  Status run(uint32_t ticks, const Actions& actions) override {
    OBBY_RETURN_IF_ERROR(uploadTable(device_, table_, actions.table));
    OBBY_RETURN_IF_ERROR(uploadTable(device_, runs_, actions.runs));
    OBBY_RETURN_IF_ERROR(uploadTable(device_, firsts_, actions.firsts));
    args_.actions = {actions.kind, actions.seed, table_.as<Action>(), runs_.as<ActionRun>(),
                     firsts_.as<uint32_t>()};
    args_.ticks = ticks;
    return device_.launch(stepKernel(kind()), &args_, size());
  }

  template <class T>
  Result<std::vector<T>> fetch(const Memory& memory, size_t count) const {
    std::vector<T> out(count);
    if (count == 0) return out;
    OBBY_RETURN_IF_ERROR(device_.download(out.data(), memory.address(), out.size() * sizeof(T)));
    return out;
  }

  Device& device_;
  StepArguments args_{};
  Memory tables_, worlds_, bodies_, episodes_, table_, runs_, firsts_;
};

}  // namespace

Result<std::unique_ptr<Batch>> makeKernelBatch(const Course& course, uint32_t worlds,
                                               Device& device) {
  Course filled = course;
  OBBY_ASSIGN(const FirstWorlds first, firstWorlds(filled, worlds));
  auto batch = std::make_unique<KernelBatch>(worlds, filled.bodyStride, device);
  OBBY_RETURN_IF_ERROR(batch->begin(filled, first));
  return std::unique_ptr<Batch>(std::move(batch));
}

namespace {

template <StepKind kKind>
const Kernel& kernelOf(const char* name) {
  static const Kernel kernel{name, kernelBody<StepArguments, stepWorld<kKind>>,
                             cuda::stepEntry(kKind), sizeof(StepArguments)};
  return kernel;
}

}  // namespace

const Kernel& stepKernel(StepKind kind) {
  switch (kind) {
    case StepKind::oneLevel: return kernelOf<StepKind::oneLevel>("step");
    case StepKind::manyLevels: return kernelOf<StepKind::manyLevels>("stepMany");
    case StepKind::bodies: break;
  }
  return kernelOf<StepKind::bodies>("stepLoose");
}

}  // namespace obby::sim
