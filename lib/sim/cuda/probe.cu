// A kernel that does nothing, in a source of its own: it tells whether a GPU runs this build's
// kernels before any of the large ones is loaded, or made from PTX, which takes minutes.
namespace obby::sim::cuda {

__global__ void nothing() {}

const void* probeEntry() { return reinterpret_cast<const void*>(nothing); }

}  // namespace obby::sim::cuda
