// A process without other ranks.
#pragma once

#include <cstdlib>

#include "train/run/ranks/join_ranks.h"

namespace obby::train {

class Alone : public JoinedRanks {
 public:
  Ranks& ranks() override { return one_; }
  uint32_t neighbour() const override { return 0; }
  void abandon(int) override {}

 private:
  OneRank one_;
};

// Returns true if mpirun or a scheduler started this process. Otherwise MPI is not initialised:
// that requires a launcher's help, which a machine may lack.
inline bool launchedByMpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace obby::train
