// Names of outcomes for messages.
#pragma once

#include "schema/obby.capnp.h"

namespace obby::solve {

inline const char* outcomeName(schema::Outcome outcome) {
  switch (outcome) {
    case schema::Outcome::RUNNING: return "running";
    case schema::Outcome::GOAL: return "goal";
    case schema::Outcome::KILLED: return "killed";
    case schema::Outcome::FELL: return "fell";
    case schema::Outcome::AVOIDED: return "avoided";
    case schema::Outcome::JUMPS: return "jumps";
    case schema::Outcome::TIMEOUT: return "timeout";
    case schema::Outcome::HURT: return "hurt";
    case schema::Outcome::FORBIDDEN: return "forbidden";
  }
  return "unknown";
}

}  // namespace obby::solve
