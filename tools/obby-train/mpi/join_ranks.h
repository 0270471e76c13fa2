// The processes that learn with this one: those that an MPI launcher started, or none.
#pragma once

#include <memory>

#include "train/ranks.h"

namespace obby::tools {

class JoinedRanks {
 public:
  virtual ~JoinedRanks() = default;  // waits for the other ranks
  virtual train::Ranks& ranks() = 0;
  // Its number among the ranks on this machine: which of its GPUs to take.
  virtual uint32_t neighbour() const = 0;
  // Ends all ranks at once, where this one cannot go on and the others do not know. Does not return
  // where there are others.
  virtual void abandon(int code) = 0;
};

// To be called once, first of all. Error: a launcher started several processes, but this program
// cannot join them.
Result<std::unique_ptr<JoinedRanks>> joinRanks(int* argc, char*** argv);

}  // namespace obby::tools
