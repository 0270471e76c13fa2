// The processes that train one network together: those that an MPI launcher started, or only this
// one.
#pragma once

#include <memory>

#include "train/ranks.h"

namespace obby::train {

class JoinedRanks {
 public:
  virtual ~JoinedRanks() = default;  // waits for the other ranks
  virtual Ranks& ranks() = 0;
  // Returns this process's number among the ranks on this machine, which chooses its GPU.
  virtual uint32_t neighbour() const = 0;
  // Ends all ranks at once, if this one fails and the others do not know. Does not return if there
  // are other ranks.
  virtual void abandon(int code) = 0;
};

// Call it once, before anything else. Error: a launcher started several processes, but this build
// cannot join them.
Result<std::unique_ptr<JoinedRanks>> joinRanks(int* argc, char*** argv);

}  // namespace obby::train
