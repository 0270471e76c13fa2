#include "calibrate/instants.h"

#include <algorithm>
#include <cmath>

#include "calibrate/noise.h"

namespace obby::calibrate {

namespace {

constexpr double kSteady = 0.1;     // max relative change of a steady acceleration between frames
constexpr double kMinChange = 0.1;  // min change of the velocity, studs/s
constexpr double kLongestDelay = 0.05;  // seconds: no engine has a longer one
constexpr double kSure = 4;             // standard errors
constexpr double kNoTime = 1e-5;        // seconds: too short to be measured

// Motion between two frames along one axis: the position error under the recorded velocities, and
// the change of velocity. Their ratio is the age.
struct Stride {
  double off, change;
  double age() const { return off / change; }
};

double along(Vec3 v, int axis) { return double(axis == 0 ? v.x : axis == 1 ? v.y : v.z); }

// Returns the acceleration along an axis from a frame to the next, studs/s^2.
double rateAt(const std::vector<Frame>& f, size_t i, int axis) {
  return (along(f[i + 1].velocity, axis) - along(f[i].velocity, axis)) /
         (f[i + 1].time - f[i].time);
}

// `own`: the age of the simulator's velocities.
void addStrides(const std::vector<Frame>& f, int axis, double own, std::vector<Stride>& to) {
  for (size_t i = 1; i + 2 < f.size(); ++i) {
    const double rate = rateAt(f, i, axis), slack = kSteady * std::fabs(rate);
    if (std::fabs(rateAt(f, i - 1, axis) - rate) > slack ||
        std::fabs(rateAt(f, i + 1, axis) - rate) > slack)
      continue;
    const double seconds = f[i + 1].time - f[i].time, change = rate * seconds;
    if (std::fabs(change) < kMinChange) continue;
    const double sum = along(f[i].velocity + f[i + 1].velocity, axis);
    const double distance = along(f[i + 1].position - f[i].position, axis);
    to.push_back({distance - 0.5 * sum * seconds - own * change, change});
  }
}

// Returns the median age, weighted by the change of velocity.
double balanceOf(std::vector<Stride>& strides) {
  std::sort(strides.begin(), strides.end(),
            [](const Stride& a, const Stride& b) { return a.age() < b.age(); });
  double all = 0, sum = 0;
  for (const Stride& s : strides) all += std::fabs(s.change);
  for (const Stride& s : strides) {
    sum += std::fabs(s.change);
    if (2 * sum >= all) return s.age();
  }
  return 0;
}

double standardError(const std::vector<Stride>& strides, double age) {
  std::vector<double> sizes;
  double squares = 0;
  for (const Stride& s : strides) {
    sizes.push_back(std::fabs(s.off - age * s.change));
    squares += s.change * s.change;
  }
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kDeviationOfMedian * *middle / std::sqrt(squares);
}

// Returns the acceleration at a frame. If the two sides differ, as in a landing, the smaller one
// counts.
Vec3 accelerationAt(const std::vector<Frame>& f, size_t i) {
  const auto at = [&](int axis) {
    const double before = i > 0 ? rateAt(f, i - 1, axis) : 0;
    const double after = i + 1 < f.size() ? rateAt(f, i, axis) : 0;
    return float(std::fabs(before) < std::fabs(after) ? before : after);
  };
  return {at(0), at(1), at(2)};
}

}  // namespace

double velocityAgeOf(std::span<const Take> takes, schema::PhysicsParams::Reader now) {
  const double own = 0.5 / (double(now.getControlRate()) * now.getSubsteps());
  std::vector<Stride> strides;
  for (const Take& take : takes) {
    for (const int axis : {0, 1, 2}) addStrides(take.track.frames, axis, own, strides);
  }
  if (strides.empty()) return 0;
  const double age = balanceOf(strides);
  const double min = std::max(kSure * standardError(strides, age), kNoTime);
  return std::fabs(age) < min ? 0 : std::clamp(age, -kLongestDelay, kLongestDelay);
}

std::vector<Take> withVelocitiesOfNow(std::span<const Take> takes,
                                      schema::PhysicsParams::Reader now) {
  const float age = float(velocityAgeOf(takes, now));
  std::vector<Take> out(takes.begin(), takes.end());
  if (age == 0) return out;
  for (size_t i = 0; i < out.size(); ++i) {
    const std::vector<Frame>& before = takes[i].track.frames;
    for (size_t k = 0; k < before.size(); ++k)
      out[i].track.frames[k].velocity += accelerationAt(before, k) * age;
  }
  return out;
}

}  // namespace obby::calibrate
