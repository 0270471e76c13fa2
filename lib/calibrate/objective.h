// How far the simulator is from the recordings under given parameters.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/parameters.h"
#include "calibrate/playback.h"
#include "io/record.h"

namespace obby::calibrate {

// A recording and the level that it was made in.
struct Take {
  Track track;
  io::Record level;
};

// Its level under other parameters, but for what the level states itself (io/physics.h).
Result<level::Level> levelWith(const Take& take, schema::PhysicsParams::Reader params);

struct ObjectiveSettings {
  double windowSeconds = 0.5;  // the simulator goes on by itself for so long; 0: to the end
  double near = 0.25;  // studs: of errors above only the order counts: another thing happened there
  double speedSeconds = 0.1;  // an error in speed counts as what it comes to in so long
  double reach = 0.5;         // studs: an error in facing counts as what it comes to so far ahead
};

// Per frame, in studs: how far off the position is, the velocity (three axes each), and the facing
// (two; 0 where it is not recorded).
constexpr uint32_t kResiduals = 8;

class Objective {
 public:
  // The takes must outlive it. `now`: what the parameters that are not fitted are. The last of what
  // is fitted is the delay from an input to what comes of it, in seconds.
  Objective(std::span<const Take> takes, std::vector<Parameter> parameters,
            schema::PhysicsParams::Reader now, const ObjectiveSettings& settings);

  // The same of other takes, of other parameters.
  Objective of(std::span<const Take> takes) const;
  Objective of(std::vector<Parameter> parameters) const;
  // The same of other parameters, begun at a point of these.
  Objective from(std::span<const double> point, std::vector<Parameter> parameters) const;

  std::span<const Take> takes() const { return takes_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const ObjectiveSettings& settings() const { return settings_; }
  size_t dimensions() const { return parameters_.size() + 1; }
  size_t frames() const;       // that are held against the recordings
  double controlRate() const;  // ticks a second

  // `point`: (dimensions), shares of the bounds. Cauchy's loss, a mean over frames, in studs^2; the
  // largest number there is where a level does not compile with these parameters, or where the
  // simulator's numbers overflow.
  double loss(std::span<const double> point) const;
  // (frames, kResiduals), of each take's windows in order. Errors as of Level::compile.
  Result<std::vector<float>> residuals(std::span<const double> point) const;

  // What a point stands for.
  void apply(std::span<const double> point, schema::PhysicsParams::Builder to) const;
  double delayAt(std::span<const double> point) const;
  // The parameters as they are now, and no delay.
  std::vector<double> start() const;
  // The point that stands for these.
  std::vector<double> pointAt(schema::PhysicsParams::Reader params, double delay) const;
  // Shares of delays so many seconds apart, over all that are tried.
  std::vector<double> delayShares(double step) const;

 private:
  Result<level::Level> levelAt(std::span<const double> point, const Take& take) const;

  std::span<const Take> takes_;
  std::vector<Parameter> parameters_;
  io::RecordBuilder now_;
  ObjectiveSettings settings_;
};

// How far off a take that plays to its end is.
struct Miss {
  double mean = 0, last = 0, most = 0;  // studs
  double parted = -1;                   // seconds until half a stud off; negative: never
};

// A take and what the simulator makes of its inputs, from its start to its end.
struct Path {
  std::vector<double> seconds;
  std::vector<Vec3> recorded, simulated;  // of the root part's centre
};
Result<Path> pathOf(const Take& take, schema::PhysicsParams::Reader params, double delay);
Miss missOf(const Path& path);

}  // namespace obby::calibrate
