#include "sim/backend.h"

#include <fmt/format.h>

#include "sim/cuda/cuda.h"

namespace obby::sim {

Result<BackendKind> backendKind(const std::string& name) {
  if (name == "auto") return BackendKind::automatic;
  if (name == "cpu") return BackendKind::cpu;
  if (name == "cuda") return BackendKind::cuda;
  return makeError(fmt::format("unknown backend '{}'", name), "give auto, cpu or cuda");
}

Result<Backend> Backend::open(BackendKind kind, uint32_t which) {
  if (kind == BackendKind::cpu) return Backend(nullptr, "simulating on the CPU");
  auto device = cuda::openDevice(which);
  if (device) {
    std::string note = "simulating on " + (*device)->name();
    return Backend(*std::move(device), std::move(note));
  }
  if (kind == BackendKind::automatic) {
    return Backend(nullptr, "simulating on the CPU: " + device.error().text());
  }
  Error error = std::move(device).error();
  if (error.hint.empty()) error.hint = "give --backend auto to use the CPU where there is no GPU";
  return error;
}

Result<std::unique_ptr<Batch>> Backend::makeBatch(Course course, uint32_t worlds,
                                                  ThreadPool& pool) const {
  if (onDevice()) return makeKernelBatch(course, worlds, *device_);
  return makeCpuBatch(std::move(course), worlds, pool);
}

}  // namespace obby::sim
