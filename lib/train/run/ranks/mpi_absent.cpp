// A build without MPI.
#include "train/run/ranks/alone.h"

namespace obby::train {

Result<std::unique_ptr<JoinedRanks>> joinRanks(int*, char***) {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* count = std::getenv(name);
    if (count != nullptr && std::atoi(count) > 1) {
      return makeError(
          "obby-train was started as one of several ranks, but was built without MPI",
          "install libopenmpi-dev and build again, or start obby-train without mpirun");
    }
  }
  return std::unique_ptr<JoinedRanks>(std::make_unique<Alone>());
}

}  // namespace obby::train
