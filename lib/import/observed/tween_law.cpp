#include "import/observed/tween_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/observation.h"
#include "import/document/pose_math.h"
#include "import/draft/motion.h"
#include "level/motion_tables.h"

namespace obby::importer {
namespace {

// Converts the engine's Rotation: degrees about X, Y and Z, in this order.
Mat3 fromAngles(Vec3 degrees) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  return rotationAbout({1, 0, 0}, double(degrees.x) * kDegree) *
         rotationAbout({0, 1, 0}, double(degrees.y) * kDegree) *
         rotationAbout({0, 0, 1}, double(degrees.z) * kDegree);
}

constexpr const char* kPoseProperties[] = {"CFrame", "Position", "Orientation", "Rotation"};
constexpr double kEndless = 1200;  // seconds; longer than the simulator accepts

// One tween of one property that still plays at the end of the run.
struct Law {
  const engine::Tween* tween;
  const engine::TweenChange* change;
  double begun = 0;  // seconds at which its delay begins

  double playTime() const { return tween->seconds * (tween->reverses ? 2 : 1); }
  double round() const { return tween->delay + playTime(); }
  double end() const {
    if (tween->repeats < 0) return std::numeric_limits<double>::infinity();
    return begun + round() * (tween->repeats + 1.0);
  }
  double easedAt(double time) const;
  // Returns `pose` with the tween's property at `time`.
  Pose at(double time, const Pose& pose) const;
};

double Law::easedAt(double time) const {
  const auto style = schema::Easing(tween->style);
  const auto direction = schema::EasingDirection(tween->direction);
  if (time >= end()) return tween->reverses ? level::ease(style, direction, 0) : 1;
  double within = std::fmod(std::max(time - begun, 0.0), round()) - tween->delay;
  if (within < 0) return level::ease(style, direction, 0);
  if (within > tween->seconds) within = playTime() - within;
  return level::ease(style, direction, std::min(within / tween->seconds, 1.0));
}

Pose Law::at(double time, const Pose& pose) const {
  const auto share = float(easedAt(time));
  if (const Pose* const to = std::get_if<Pose>(&change->to)) {
    const Pose* const from = std::get_if<Pose>(&change->from);
    return from ? between(*from, *to, share) : pose;
  }
  const Vec3* const from = std::get_if<Vec3>(&change->from);
  const Vec3* const to = std::get_if<Vec3>(&change->to);
  if (!from || !to) return pose;
  const Vec3 value = *from + (*to - *from) * share;
  if (change->property == "Position") return {value, pose.rotation};
  return {pose.position,
          change->property == "Rotation" ? fromAngles(value) : fromOrientation(value)};
}

// Returns the tween of the property that began last. The pose at `frame` shows when it began: its
// first step is in the frame in which it begins to play, or in the next one.
std::optional<Law> lastLaw(const std::vector<const engine::Tween*>& tweens,
                           const std::string& property, const Pose& last, uint32_t frame) {
  std::optional<Law> found;
  for (const engine::Tween* const tween : tweens)
    for (const engine::TweenChange& change : tween->changes)
      if (change.property == property) found = Law{tween, &change};
  if (!found || !(found->round() > 0) || !std::isfinite(found->round())) return std::nullopt;
  const double time = frame * engine::kFrame, begun = found->tween->time - found->tween->delay;
  const auto off = [&](double from) {
    found->begun = from;
    const Pose pose = found->at(time, last);
    return length(pose.position - last.position) +
           length(rotationVector(inverse(pose.rotation) * last.rotation));
  };
  found->begun = off(begun) <= off(begun - engine::kFrame) ? begun : begun - engine::kFrame;
  return found->end() > time ? found : std::nullopt;
}

// Returns true if the tweens predict the last frames.
bool explains(const std::vector<Law>& laws, const std::vector<Pose>& poses) {
  constexpr float kPlace = 0.1f, kTurn = 0.05f;
  for (const size_t back : {0, 1, 20, 60}) {
    if (back >= poses.size()) break;
    const size_t frame = poses.size() - 1 - back;
    Pose pose = poses[frame];
    for (const Law& law : laws)
      if (law.tween->time < double(frame) * engine::kFrame)
        pose = law.at(double(frame) * engine::kFrame, pose);
    if (!(length(pose.position - poses[frame].position) < kPlace) ||
        !(length(rotationVector(inverse(pose.rotation) * poses[frame].rotation)) < kTurn))
      return false;
  }
  return true;
}

// Returns the tweens' poses at evenly spaced times from `from` to `to`, and where they reverse.
std::vector<PoseSample> lawSamples(const std::vector<Law>& laws, const Pose& last, double from,
                                   double to) {
  constexpr double kMax = 6000, kJust = 1e-6;
  const double step = std::max(engine::kFrame, (to - from) / kMax);
  std::vector<double> times;
  for (double time = from + step; time < to - kJust; time += step) times.push_back(time);
  for (const Law& law : laws) {
    const double round = law.begun + std::floor((from - law.begun) / law.round()) * law.round();
    for (const double turn : {law.tween->delay, law.tween->delay + law.tween->seconds})
      for (const double time : {round + turn, round + turn + law.round()})
        if (time > from + kJust && time < to - kJust) times.push_back(time);
  }
  times.push_back(to - kJust);
  std::sort(times.begin(), times.end());
  std::vector<PoseSample> samples;
  for (const double time : times) {
    Pose pose = last;
    for (const Law& law : laws) pose = law.at(time, pose);
    samples.push_back({time - from, pose});
  }
  return samples;
}

Motion endless(const std::vector<Law>& laws, const Pose& last, double now) {
  Motion motion;
  const double round = laws.front().round();
  const double from =
      laws.front().begun + std::ceil((now - laws.front().begun) / round - 1e-6) * round;
  Pose start = last;
  for (const Law& law : laws) start = law.at(from + 1e-6, start);
  motion.keys = keysThrough(start, lawSamples(laws, last, from, from + round));
  const double since = std::fmod(from, round);
  if (since > 1e-4 && round - since > 1e-4) motion.offset = float(round - since);
  return motion;
}

// Returns the observed motion, continued until the tweens end.
Motion once(const std::vector<Law>& laws, const std::vector<Pose>& poses, double end) {
  Motion motion;
  motion.repeat = Repeat::once;
  const double now = double(poses.size() - 1) * engine::kFrame;
  std::vector<PoseSample> samples;
  for (size_t i = 1; i < poses.size(); ++i)
    samples.push_back({double(i) * engine::kFrame, poses[i]});
  for (const PoseSample& sample : lawSamples(laws, poses.back(), now, end))
    samples.push_back({now + sample.time, sample.pose});
  motion.keys = keysThrough(poses.front(), samples);
  return motion;
}

// Returns the tweens that play at the last frame.
std::vector<Law> lawsAt(const std::vector<Pose>& poses,
                        const std::vector<const engine::Tween*>& tweens) {
  const auto frame = uint32_t(poses.size() - 1);
  std::vector<Law> laws;
  for (const char* const property : kPoseProperties)
    if (const auto law = lastLaw(tweens, property, poses.back(), frame)) laws.push_back(*law);
  return laws;
}

double endOf(const std::vector<Law>& laws) {
  double end = 0;
  for (const Law& law : laws) end = std::max(end, law.end());
  return end;
}

}  // namespace

TweenLaws::TweenLaws(const engine::Observation& seen, double origin) : tweens_(seen.tweens) {
  for (engine::Tween& tween : tweens_) {
    tween.time -= origin;
    byTarget_[tween.target].push_back(&tween);
  }
}

std::optional<Motion> TweenLaws::outlasting(const std::vector<Pose>& poses, InstanceId part) const {
  const auto tweens = byTarget_.find(part);
  if (tweens == byTarget_.end()) return std::nullopt;
  const std::vector<Law> laws = lawsAt(poses, tweens->second);
  if (laws.empty() || !explains(laws, poses)) return std::nullopt;
  const double end = endOf(laws);
  const bool rounds = std::all_of(laws.begin(), laws.end(), [&](const Law& law) {
    return law.tween->repeats != 0 && std::abs(law.round() - laws.front().round()) < 1e-6;
  });
  if (rounds && end > kEndless)
    return endless(laws, poses.back(), double(poses.size() - 1) * engine::kFrame);
  return std::isfinite(end) ? std::optional(once(laws, poses, end)) : std::nullopt;
}

std::optional<double> TweenLaws::end(const std::vector<Pose>& poses, InstanceId part) const {
  const auto tweens = byTarget_.find(part);
  if (tweens == byTarget_.end()) return std::nullopt;
  std::vector<Law> laws = lawsAt(poses, tweens->second);
  std::erase_if(laws, [](const Law& law) { return law.tween->repeats == 0; });
  const double end = endOf(laws);
  return laws.empty() || end > kEndless ? std::nullopt : std::optional(end);
}

}  // namespace obby::importer
