// A kernel that does nothing, in a source of its own. It shows whether a GPU runs this build's
// kernels before a large one is loaded or compiled from PTX, which takes minutes.
namespace obby::sim::cuda {

__global__ void nothing() {}

const void* probeEntry() { return reinterpret_cast<const void*>(nothing); }

}  // namespace obby::sim::cuda
