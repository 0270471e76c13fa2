// Turns the poses of parts that move by themselves, frame by frame, into motions.
#include <algorithm>
#include <cmath>

#include "engine/observation.h"
#include "import/document/pose_math.h"
#include "import/draft/motion.h"
#include "import/observed/roles.h"
#include "import/observed/rounds.h"
#include "import/observed/settle.h"
#include "import/observed/steady_turn.h"
#include "import/observed/tween_law.h"
#include "level/rotation.h"

namespace obby::importer {

std::vector<Pose> posesOf(const Pose& start, const engine::Track& track, uint32_t first,
                          uint32_t frames) {
  std::vector<Pose> poses;
  Pose now = start;
  size_t next = 0;
  for (uint32_t frame = 0; frame < frames; ++frame) {
    while (next < track.poses.size() && track.poses[next].frame <= first + frame)
      now = track.poses[next++].pose;
    poses.push_back(now);
  }
  return poses;
}

namespace {

constexpr size_t kSmoothSteps = 9, kRareSteps = 60;  // max frames between steps of a steady turn

std::vector<PoseSample> samplesOf(const std::vector<Pose>& poses, size_t from, size_t count) {
  std::vector<PoseSample> samples;
  for (size_t i = 1; i <= count; ++i)
    samples.push_back({double(i) * engine::kFrame, poses[from + i]});
  return samples;
}

// Returns the samples with changes: a script that sets a pose every other frame intends a smooth
// motion.
std::vector<PoseSample> changesIn(const std::vector<PoseSample>& samples, const Pose& start) {
  std::vector<PoseSample> changes;
  const Pose* last = &start;
  for (const PoseSample& sample : samples) {
    if (!(sample.pose.position == last->position) ||
        !(sample.pose.rotation.x == last->rotation.x) ||
        !(sample.pose.rotation.y == last->rotation.y))
      changes.push_back(sample);
    last = &sample.pose;
  }
  return changes;
}

// Returns a motion that repeats the round for ever.
Motion roundMotion(const std::vector<Pose>& poses, const Round& round) {
  Motion motion;
  const double since = std::fmod(double(round.begin) * engine::kFrame, round.seconds);
  auto samples = changesIn(samplesOf(poses, round.begin, round.frames), poses[round.begin]);
  while (!samples.empty() && samples.back().time > round.seconds - engine::kFrame / 2)
    samples.pop_back();
  motion.keys = keysFrom(poses[round.begin], samples, round.seconds, true);
  if (since > 0) motion.offset = float(round.seconds - since);
  return motion;
}

// Returns a motion that happens once, from its first change on.
Motion onceOf(const std::vector<Pose>& poses, size_t begin, size_t end) {
  Motion motion;
  motion.repeat = Repeat::once;
  const size_t count = end - begin;
  const auto samples = changesIn(samplesOf(poses, begin, count), poses[begin]);
  motion.keys = keysFrom(poses[begin], samples, double(count) * engine::kFrame, false);
  if (begin > 0) motion.offset = -float(double(begin) * engine::kFrame);
  return motion;
}

// Returns the motion of a part that turns all the time, or nullopt if its positions fit no turn.
std::optional<Motion> turningMotion(const std::vector<Pose>& poses, const SteadyTurn& turn,
                                    size_t rest) {
  Motion motion;
  const Pose& begin = poses[turn.begin];
  const auto rotationAt = [&](double seconds) {
    return begin.rotation * rotationAbout(turn.axis, turn.speed * (seconds - turn.since));
  };
  if (turn.pivot) {
    if (std::abs(turn.since) > 1e-4) motion.offset = -float(turn.since);
    if (!samePose(begin, poses[0]))
      motion.keys = {{0, begin, Easing::linear, EasingDirection::out}};
  } else {
    std::vector<Pose> places = poses;
    for (Pose& place : places) place.rotation = {};
    const auto found = motionOf(places, rest);
    if (!found) return std::nullopt;
    motion = *found;
    const Mat3 rotation = rotationAt(-double(motion.offset));
    for (MotionKey& key : motion.keys) key.pose.rotation = rotation;
  }
  motion.spin = Spin{turn.axis, float(turn.speed), turn.pivot.value_or(Vec3{})};
  return motion;
}

std::optional<Motion> turningMotion(const std::vector<Pose>& poses, size_t longestGap,
                                    size_t rest) {
  const auto turn = steadyTurnIn(poses, longestGap);
  return turn ? turningMotion(poses, *turn, rest) : std::nullopt;
}

}  // namespace

std::optional<Motion> motionOf(const std::vector<Pose>& poses, size_t rest) {
  size_t end = poses.size() - 1;
  while (end > 0 && isSame(poses[end - 1], poses[end])) --end;
  if (end == 0) return std::nullopt;
  if (auto turning = turningMotion(poses, kSmoothSteps, rest)) return turning;
  if (const Round round = roundIn(poses); round.frames > 0) return roundMotion(poses, round);
  if (poses.size() - end < rest) return turningMotion(poses, kRareSteps, rest);  // it still moves
  size_t begin = 0;
  while (begin < end && isSame(poses[begin + 1], poses[begin])) ++begin;
  return onceOf(poses, begin, end);
}

engine::Line moverOf(const engine::Observation& seen, InstanceId part, const engine::Track& track) {
  if (track.line.script != kNoInstance && track.line.line > 0) return track.line;
  for (const engine::Change& change : seen.changes)
    if (change.target == track.driver && change.line.script != kNoInstance) return change.line;
  for (const engine::Tween& tween : seen.tweens)
    if (tween.target == part || tween.target == track.driver) return tween.line;
  return track.line;
}

namespace {

// Notes rounds that end later in the game: they go on for ever in the level.
void noteEnd(RoleContext& context, InstanceId id, const Motion& motion,
             const std::optional<double>& end, const std::string& reason) {
  if (end && motion.repeat != Repeat::once)
    context.level.noteUnmodelled("motion that ends", context.tree, id,
                                 "simulated as endless; in the game it ends after " +
                                     std::to_string(std::lround(*end)) + " s; " + reason);
}

}  // namespace

void movingFromObservation(RoleContext& context, const engine::Report& report) {
  constexpr size_t kLongRest = 300;  // frames of rest after which a part counts as stopped
  const engine::Observation& seen = report.undisturbed;
  const TweenLaws laws(seen);
  const size_t own = context.tree.size() - report.made.size();
  for (const auto& [id, track] : seen.tracks) {
    PartDraft* const part = context.part(id);
    if (!part || part->motion || !movesByItself(report, id)) continue;
    const auto poses = posesOf(poseAtStart(track, id >= own), track, 0, seen.frames + 1);
    const std::string reason = lineReason(context.tree, moverOf(seen, id, track));
    auto motion = motionOf(poses, report.over ? 1 : kLongRest);
    if (motion) noteEnd(context, id, *motion, laws.end(poses, id), reason);
    if (!motion) motion = laws.outlasting(poses, id);
    if (motion) {
      motion->carries = track.driver != kNoInstance;
      giveMotion(context, id, *motion, reason, false);
    } else {
      context.level.noteUnmodelled("motion without a period", context.tree, id,
                                   "the part stays where it is at the start; " + reason);
      if (!part->anchored) part->evidence.push_back({"held", reason, false});
      part->anchored = true;
    }
  }
}

}  // namespace obby::importer
