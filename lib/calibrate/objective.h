// The distance between the simulator and the recordings under given parameters.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/parameters.h"
#include "calibrate/playback.h"
#include "io/record.h"

namespace obby::calibrate {

// A recording with its level.
struct Take {
  Track track;
  io::Record level;
};

// Compiles the take's level under `params`, except for those that the level defines (io/physics.h).
Result<level::Level> levelWith(const Take& take, schema::PhysicsParams::Reader params);

struct ObjectiveSettings {
  double windowSeconds = 0.5;  // length of a free-running window; 0: to the end
  double near = 0.25;  // studs: scale of the loss; larger errors, as from a different event, count
                       // logarithmically
  double speedSeconds = 0.1;  // converts an error in speed to studs
  double reach = 0.5;         // studs: converts an error in facing to studs
};

// Residuals per frame, in studs: position and velocity (three axes each) and facing (two; 0 if not
// recorded).
constexpr uint32_t kResiduals = 8;

class Objective {
 public:
  // The takes must outlive the objective. `now`: values of the parameters that are not fitted. The
  // last coordinate is the delay from an input to its effect, in seconds.
  Objective(std::span<const Take> takes, std::vector<Parameter> parameters,
            schema::PhysicsParams::Reader now, const ObjectiveSettings& settings);

  // Return a copy with other takes or other parameters.
  Objective of(std::span<const Take> takes) const;
  Objective of(std::vector<Parameter> parameters) const;
  // Returns a copy with other parameters, whose unfitted values come from `point`.
  Objective from(std::span<const double> point, std::vector<Parameter> parameters) const;

  std::span<const Take> takes() const { return takes_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const ObjectiveSettings& settings() const { return settings_; }
  size_t dimensions() const { return parameters_.size() + 1; }
  size_t frames() const;       // frames compared
  double controlRate() const;  // ticks a second

  // `point`: (dimensions), shares of the bounds. Returns Cauchy's loss, a mean over frames, in
  // studs^2. Returns the max double if a level does not compile with these parameters or the
  // simulation overflows.
  double loss(std::span<const double> point) const;
  // Returns (frames, kResiduals), for the windows of each take in order. Errors: those of
  // Level::compile.
  Result<std::vector<float>> residuals(std::span<const double> point) const;

  // Convert a point to parameter values and a delay.
  void apply(std::span<const double> point, schema::PhysicsParams::Builder to) const;
  double delayAt(std::span<const double> point) const;
  // Returns the point of the current parameters and no delay.
  std::vector<double> start() const;
  // Returns the point of these values.
  std::vector<double> pointAt(schema::PhysicsParams::Reader params, double delay) const;
  // Returns delays `step` seconds apart, over the whole range, as shares.
  std::vector<double> delayShares(double step) const;

 private:
  Result<level::Level> levelAt(std::span<const double> point, const Take& take) const;

  std::span<const Take> takes_;
  std::vector<Parameter> parameters_;
  io::RecordBuilder now_;
  ObjectiveSettings settings_;
};

// Errors of a complete playback.
struct Miss {
  double mean = 0, last = 0, max = 0;  // studs
  double parted = -1;                  // seconds until half a stud off; -1: never
};

// A take and its complete playback in the simulator.
struct Path {
  std::vector<double> seconds;
  std::vector<Vec3> recorded, simulated;  // centre of the root part, studs
};
Result<Path> pathOf(const Take& take, schema::PhysicsParams::Reader params, double delay);
Miss missOf(const Path& path);

}  // namespace obby::calibrate
