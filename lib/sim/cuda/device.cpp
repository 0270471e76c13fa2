// A GPU through the CUDA runtime. The error of every call is returned with the driver's message.
#include <cuda_runtime_api.h>
#include <fmt/format.h>

#include "sim/cuda/cuda.h"

namespace obby::sim::cuda {
namespace {

constexpr uint32_t kMaxThreads = 128, kMinThreads = 32;

Status check(cudaError_t code, const char* what) {
  if (code == cudaSuccess) return {};
  return makeError(fmt::format("CUDA: {}: {}", what, cudaGetErrorString(code)));
}

class Gpu : public Device {
 public:
  ~Gpu() override {
    for (const cudaStream_t stream : {copies_, kernels_}) {
      if (stream != nullptr) cudaStreamDestroy(stream);
    }
    for (const cudaEvent_t event : {asked_, done_}) {
      if (event != nullptr) cudaEventDestroy(event);
    }
  }

  Status open(uint32_t which) {
    int count = 0;
    OBBY_RETURN_IF_ERROR(check(cudaGetDeviceCount(&count), "no usable GPU"));
    if (count == 0) return makeError("CUDA: no usable GPU");
    number_ = int(which % uint32_t(count));
    OBBY_RETURN_IF_ERROR(check(cudaSetDevice(number_), "cannot use the GPU"));
    for (cudaStream_t* const stream : {&copies_, &kernels_}) {
      OBBY_RETURN_IF_ERROR(
          check(cudaStreamCreateWithFlags(stream, cudaStreamNonBlocking), "cannot use the GPU"));
    }
    for (cudaEvent_t* const event : {&asked_, &done_}) {
      OBBY_RETURN_IF_ERROR(
          check(cudaEventCreateWithFlags(event, cudaEventDisableTiming), "cannot use the GPU"));
    }
    OBBY_RETURN_IF_ERROR(
        check(cudaGetDeviceProperties(&properties_, number_), "cannot read the GPU's properties"));
    return tryKernel();
  }

  std::string name() const override { return properties_.name; }

  Result<void*> allocate(size_t bytes) override {
    void* memory = nullptr;
    OBBY_RETURN_IF_ERROR(check(cudaSetDevice(number_), "cannot use the GPU"));  // set per thread
    const cudaError_t code = cudaMalloc(&memory, bytes);
    if (code == cudaErrorMemoryAllocation) cudaGetLastError();  // clears the handled error
    OBBY_RETURN_IF_ERROR(
        check(code, fmt::format("cannot allocate {} bytes on the GPU", bytes).c_str()));
    return memory;
  }
  void release(void* memory) override { cudaFree(memory); }
  Status upload(void* to, const void* from, size_t bytes) override {
    return check(cudaMemcpy(to, from, bytes, cudaMemcpyHostToDevice),
                 "cannot copy data to the GPU");
  }
  Status uploadAside(void* to, const void* from, size_t bytes) override {
    OBBY_RETURN_IF_ERROR(check(cudaSetDevice(number_), "cannot use the GPU"));  // set per thread
    OBBY_RETURN_IF_ERROR(check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, copies_),
                               "cannot copy data to the GPU"));
    return check(cudaStreamSynchronize(copies_), "cannot copy data to the GPU");
  }
  Status download(void* to, const void* from, size_t bytes) const override {
    return check(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost),
                 "cannot copy data from the GPU");
  }
  Status copy(void* to, const void* from, size_t bytes) override {
    return check(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToDevice),
                 "cannot copy data on the GPU");
  }
  Status fill(void* to, uint8_t value, size_t bytes) override {
    return check(cudaMemset(to, value, bytes), "cannot clear GPU memory");
  }

  Status launch(const Kernel& kernel, const void* arguments, uint32_t count) override {
    OBBY_RETURN_IF_ERROR(enqueue(kernel, arguments, count));
    return check(cudaDeviceSynchronize(), kernel.name);
  }

  Status enqueue(const Kernel& kernel, const void* arguments, uint32_t count) override {
    return enqueueOn(nullptr, kernel, arguments, count);
  }

  // Runs the second kernel on its own stream, ordered after earlier and before later work.
  Status enqueueTogether(const Kernel& a, const Kernel& b, const void* arguments,
                         uint32_t count) override {
    OBBY_RETURN_IF_ERROR(check(cudaEventRecord(asked_, nullptr), b.name));
    OBBY_RETURN_IF_ERROR(check(cudaStreamWaitEvent(kernels_, asked_, 0), b.name));
    OBBY_RETURN_IF_ERROR(enqueueOn(kernels_, b, arguments, count));
    OBBY_RETURN_IF_ERROR(enqueueOn(nullptr, a, arguments, count));
    OBBY_RETURN_IF_ERROR(check(cudaEventRecord(done_, kernels_), b.name));
    return check(cudaStreamWaitEvent(nullptr, done_, 0), b.name);
  }

  Result<KernelFacts> facts(const Kernel& kernel) const override {
    cudaFuncAttributes a{};
    OBBY_RETURN_IF_ERROR(check(cudaFuncGetAttributes(&a, kernel.entry), kernel.name));
    int blocks = 0;
    OBBY_RETURN_IF_ERROR(
        check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, kernel.entry, kMaxThreads, 0),
              kernel.name));
    return KernelFacts{a.numRegs, int(a.localSizeBytes), int(kMaxThreads), blocks,
                       properties_.multiProcessorCount};
  }

 private:
  Status enqueueOn(cudaStream_t stream, const Kernel& kernel, const void* arguments,
                   uint32_t count) {
    if (count == 0) return {};
    const uint32_t threads = threadsFor(count), blocks = (count + threads - 1) / threads;
    void* values[] = {const_cast<void*>(arguments), &count};
    return check(cudaLaunchKernel(kernel.entry, dim3(blocks), dim3(threads), values, 0, stream),
                 kernel.name);
  }

  // A GPU that is older than all targets of this build has memory, but runs no kernel. Finding out
  // now, when there may be a choice, is better than at the first launch.
  Status tryKernel() const {
    const std::string what =
        fmt::format("{} (compute capability {}.{}) cannot run the kernels of this build", name(),
                    properties_.major, properties_.minor);
    OBBY_RETURN_IF_ERROR(
        check(cudaLaunchKernel(probeEntry(), dim3(1), dim3(1), nullptr, 0, nullptr), what.c_str()));
    return check(cudaDeviceSynchronize(), what.c_str());
  }

  // Spreads few worlds over all multiprocessors.
  uint32_t threadsFor(uint32_t count) const {
    uint32_t threads = kMaxThreads;
    while (threads > kMinThreads && count / threads < uint32_t(properties_.multiProcessorCount)) {
      threads /= 2;
    }
    return threads;
  }

  cudaDeviceProp properties_{};
  int number_ = 0;
  cudaStream_t copies_ = nullptr, kernels_ = nullptr;  // streams of copies and of kernels
  cudaEvent_t asked_ = nullptr, done_ = nullptr;       // events of enqueueTogether()
};

}  // namespace

Result<std::unique_ptr<Device>> openDevice(uint32_t which) {
  auto gpu = std::make_unique<Gpu>();
  OBBY_RETURN_IF_ERROR(gpu->open(which));
  return std::unique_ptr<Device>(std::move(gpu));
}

}  // namespace obby::sim::cuda
