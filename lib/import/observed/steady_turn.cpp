#include "import/observed/steady_turn.h"

#include <algorithm>
#include <cmath>

#include "engine/observation.h"
#include "import/document/pose_math.h"
#include "level/rotation.h"

namespace obby::importer {
namespace {

constexpr size_t kShortest = 60;  // min frames of a steady turn

bool sameRotation(const Mat3& a, const Mat3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

// The rotations from frame to frame, for frames that change the rotation.
struct Steps {
  std::vector<size_t> frames;
  std::vector<Vec3> turns;
};

Steps stepsIn(const std::vector<Pose>& poses) {
  constexpr float kUnturned = 1e-5f;  // radians
  Steps steps;
  for (size_t i = 1; i < poses.size(); ++i) {
    const Mat3 &before = poses[i - 1].rotation, &now = poses[i].rotation;
    if (sameRotation(before, now)) continue;
    const Vec3 turn = rotationVector(inverse(before) * now);
    if (length(turn) < kUnturned) continue;
    steps.frames.push_back(i);
    steps.turns.push_back(turn);
  }
  return steps;
}

// Returns true if the steps come often enough, up to the last frame.
bool goesOn(const Steps& steps, size_t frames, size_t longestGap) {
  if (steps.frames.size() < 3 || frames - steps.frames.front() < kShortest) return false;
  for (size_t i = 1; i < steps.frames.size(); ++i)
    if (steps.frames[i] - steps.frames[i - 1] > longestGap) return false;
  return frames - 1 - steps.frames.back() <= longestGap;
}

// Returns the angle of each step about `axis`, in radians. Returns nullopt if one is about another
// axis, or much larger than the others.
std::optional<std::vector<double>> anglesAbout(Vec3 axis, const Steps& steps) {
  constexpr float kOff = 0.02f, kLittle = 1e-4f;
  std::vector<double> angles;
  for (const Vec3 turn : steps.turns) {
    const float along = dot(turn, axis);
    if (!(along > 0) || length(turn - axis * along) > kOff * along + kLittle) return std::nullopt;
    angles.push_back(double(along));
  }
  std::vector<double> sorted = angles;
  std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2),
                   sorted.end());
  const double usual = sorted[sorted.size() / 2];
  const bool alike =
      std::all_of(angles.begin(), angles.end(), [&](double a) { return a <= 2.5 * usual + 1e-3; });
  return alike ? std::optional(angles) : std::nullopt;
}

struct Fit {
  double slope = 0, start = 0;
};

// Fits a line through `values`, one per frame, by least squares.
Fit fitThrough(const std::vector<double>& values) {
  const auto n = double(values.size());
  double sum = 0, moment = 0;
  for (size_t i = 0; i < values.size(); ++i) sum += values[i], moment += double(i) * values[i];
  const double middle = (n - 1) / 2, spread = n * (n * n - 1) / 12;
  const double slope = (moment - middle * sum) / spread;
  return {slope, sum / n - slope * middle};
}

// Returns the rotation angle at each frame from `begin` on.
std::vector<double> turnedBy(const Steps& steps, const std::vector<double>& angles, size_t begin,
                             size_t frames) {
  std::vector<double> all = {0};
  size_t next = 0;
  for (size_t frame = begin + 1; frame < frames; ++frame) {
    double now = all.back();
    if (next < steps.frames.size() && steps.frames[next] == frame) now += angles[next++];
    all.push_back(now);
  }
  return all;
}

// Returns the fixed point of a turn, in the turned frame.
Vec3 stillPoint(const Pose& turned) {
  const Vec3 turn = rotationVector(turned.rotation);
  const Vec3 axis = normalize(turn);
  const Vec3 shift = turned.position - axis * dot(turned.position, axis);
  const double half = double(length(turn)) / 2;
  return shift * 0.5f + cross(axis, shift) * float(0.5 / std::tan(half));
}

bool staysAt(const std::vector<Pose>& poses, size_t begin, Vec3 pivot) {
  const float slack = 0.01f + 1e-4f * length(pivot);
  const Vec3 there = toWorld(poses[begin], pivot);
  return std::all_of(poses.begin() + std::ptrdiff_t(begin), poses.end(), [&](const Pose& pose) {
    return length(toWorld(pose, pivot) - there) <= slack;
  });
}

// Finds the pivot after a quarter of a turn, which shows it best.
std::optional<Vec3> pivotIn(const std::vector<Pose>& poses, size_t begin,
                            const std::vector<double>& turned) {
  constexpr double kQuarter = 1.57;
  if (staysAt(poses, begin, {})) return Vec3{};
  size_t quarter = 1;
  while (quarter + 1 < turned.size() && turned[quarter] < kQuarter) ++quarter;
  const Pose relative = inverse(poses[begin]) * poses[begin + quarter];
  const Vec3 pivot = stillPoint(relative);
  return isFinite(pivot) && staysAt(poses, begin, pivot) ? std::optional(pivot) : std::nullopt;
}

}  // namespace

std::optional<SteadyTurn> steadyTurnIn(const std::vector<Pose>& poses, size_t longestGap) {
  const Steps steps = stepsIn(poses);
  if (!goesOn(steps, poses.size(), longestGap)) return std::nullopt;
  Vec3 sum;
  for (const Vec3 turn : steps.turns) sum = sum + turn;
  if (!(length(sum) > 0)) return std::nullopt;
  SteadyTurn found;
  found.axis = normalize(sum);
  const auto angles = anglesAbout(found.axis, steps);
  if (!angles) return std::nullopt;
  found.begin = steps.frames.front() - 1;
  const auto turned = turnedBy(steps, *angles, found.begin, poses.size());
  const Fit fit = fitThrough(turned);
  const double slack = *std::max_element(angles->begin(), angles->end()) + 0.01;
  for (size_t i = 0; i < turned.size(); ++i)
    if (std::abs(turned[i] - fit.start - fit.slope * double(i)) > slack) return std::nullopt;
  found.speed = fit.slope / engine::kFrame;
  found.since = (double(found.begin) - fit.start / fit.slope) * engine::kFrame;
  found.pivot = pivotIn(poses, found.begin, turned);
  return found;
}

}  // namespace obby::importer
