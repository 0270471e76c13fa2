// A process that joins no others.
#pragma once

#include <cstdlib>

#include "mpi/join_ranks.h"

namespace obby::tools {

class Alone : public JoinedRanks {
 public:
  train::Ranks& ranks() override { return one_; }
  uint32_t neighbour() const override { return 0; }
  void abandon(int) override {}

 private:
  train::OneRank one_;
};

// Did mpirun, or a scheduler in its place, start this process? Where it did not MPI is left asleep:
// to start it takes a launcher's help, which a machine need not have.
inline bool launchedByMpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

}  // namespace obby::tools
