// Selects where worlds are simulated: on the CPU's lanes or on a GPU. The results are the same.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "sim/batch.h"

namespace obby::sim {

// The values have the order of the choices of --backend.
enum class BackendKind { automatic, cpu, cuda };

// Parses "auto", "cpu" or "cuda". An error names the choices.
Result<BackendKind> backendKind(const std::string& name);

class Backend {
 public:
  // Without a GPU that runs this build's kernels, `cuda` is an error, and `automatic` takes the CPU
  // and says why in note(). `which` is the index of a GPU, modulo the number of GPUs.
  static Result<Backend> open(BackendKind kind, uint32_t which = 0);

  bool onDevice() const { return device_ != nullptr; }
  Device* device() const { return device_.get(); }   // null for the CPU's lanes
  const std::string& note() const { return note_; }  // a text to display; never empty

  // The batch must not outlive the backend or the pool.
  Result<std::unique_ptr<Batch>> makeBatch(Course course, uint32_t worlds, ThreadPool& pool) const;

 private:
  Backend(std::unique_ptr<Device> device, std::string note)
      : device_(std::move(device)), note_(std::move(note)) {}

  std::unique_ptr<Device> device_;
  std::string note_;
};

}  // namespace obby::sim
