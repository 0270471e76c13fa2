// Reasons why a fit does not reach the requested tolerance.
#pragma once

#include <string>
#include <vector>

#include "calibrate/fit.h"

namespace obby::calibrate {

// Half a second of a recording that the simulator does not reproduce from the recorded state.
struct Strange {
  size_t take = 0;  // index; several takes may share a name
  std::string recording;
  double from = 0, to = 0;                 // seconds
  double off = 0;                          // mean distance, studs
  sim::State state = sim::State::running;  // the player's state at the largest distance
  // Parameters that the fitted recordings do not determine and that would reduce the error. If
  // empty, no such parameter explains the error.
  std::vector<std::string> untold = {};
};

struct Shortfall {
  double noise = 0;               // error of the recorded positions themselves, studs
  std::vector<std::string> ends;  // parameters at an end of the searched range
  std::vector<Strange> strange;   // windows beyond the tolerance, worst first; at most 3
  bool stopped = false;           // the fit was interrupted; the rest is not examined
};

// Errors: those of Level::compile.
Result<Shortfall> shortfallOf(std::span<const Take> takes, const Fit& fit,
                              schema::PhysicsParams::Reader params, double tolerance);

// Return a short text for a warning, and the full list of reasons.
std::string shortOf(const Shortfall& shortfall, double tolerance);
std::vector<std::string> reasonsOf(const Shortfall& shortfall, double tolerance);

}  // namespace obby::calibrate
