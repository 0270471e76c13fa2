// Why a fit does not come as near to its recordings as was asked.
#pragma once

#include <string>
#include <vector>

#include "calibrate/fit.h"

namespace obby::calibrate {

// Half a second of a recording in which the simulator, begun as the player was, does something
// else.
struct Strange {
  size_t take = 0;  // of those that were given: several may have one name
  std::string recording;
  double from = 0, to = 0;                 // seconds
  double off = 0;                          // studs, on average
  sim::State state = sim::State::running;  // of the player where it is off most
  // Parameters that the fitted recordings do not tell, and that would bring it nearer. None: it is
  // so whatever they are.
  std::vector<std::string> untold = {};
};

struct Shortfall {
  double noise = 0;  // studs that positions are off by themselves: they jump from frame to frame
  std::vector<std::string> ends;  // parameters at an end of the values that were tried
  std::vector<Strange> strange;  // those off by more than the tolerance, the worst first; 3 at most
  bool stopped = false;          // the fit was: that is reason enough, and nothing is looked for
};

// Errors as of Level::compile.
Result<Shortfall> shortfallOf(std::span<const Take> takes, const Fit& fit,
                              schema::PhysicsParams::Reader params, double tolerance);

// In few words, for a warning; and at length, a reason each.
std::string shortOf(const Shortfall& shortfall, double tolerance);
std::vector<std::string> reasonsOf(const Shortfall& shortfall, double tolerance);

}  // namespace obby::calibrate
