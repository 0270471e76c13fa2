// Parts that move by themselves: their poses, frame by frame, as motions.
#include <algorithm>
#include <cmath>

#include "import/frame_time.h"
#include "import/motion.h"
#include "import/observed/roles.h"
#include "import/observed/settle.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr float kSamePlace = 0.02f;  // studs
constexpr float kSameTurn = 0.01f;   // radians

bool near(const Pose& a, const Pose& b) {
  return length(a.position - b.position) < kSamePlace &&
         length(a.rotation.x - b.rotation.x) < kSameTurn &&
         length(a.rotation.y - b.rotation.y) < kSameTurn;
}

}  // namespace

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

// The smallest period, in frames, with which the poses repeat to their end; 0: there is none of which
// two rounds were seen.
size_t periodOf(const std::vector<Pose>& poses) {
  const size_t count = poses.size();
  for (size_t period = 1; 2 * period < count; ++period) {
    // The last round but one and all of the last: far from the start, where scripts still wait.
    const size_t from = count - 2 * period;
    bool repeats = true;
    for (size_t i = count - period; i-- > from && repeats;) repeats = near(poses[i], poses[i + period]);
    if (!repeats) continue;
    const bool still = std::all_of(poses.end() - std::ptrdiff_t(period), poses.end(),
                                   [&](const Pose& pose) { return near(pose, poses.back()); });
    if (!still || period > 600) return still ? 0 : period;
  }
  return 0;
}

namespace {

// The first frame from which the poses repeat.
size_t beginOf(const std::vector<Pose>& poses, size_t period) {
  size_t begin = poses.size() - period;
  while (begin > 0 && near(poses[begin - 1], poses[begin - 1 + period])) --begin;
  return begin;
}

std::vector<PoseSample> samplesOf(const std::vector<Pose>& poses, size_t from, size_t count) {
  std::vector<PoseSample> samples;
  for (size_t i = 1; i <= count; ++i) samples.push_back({double(i) * kFrame, poses[from + i]});
  return samples;
}

// A round that begins at frame `begin` and goes on for ever.
Motion roundOf(const std::vector<Pose>& poses, size_t begin, size_t period) {
  Motion motion;
  const double seconds = double(period) * kFrame;
  const auto samples = samplesOf(poses, begin, period);
  const size_t phase = (period - begin % period) % period;
  if (const auto spin = spinFrom(poses[begin], samples, seconds)) {
    motion.spin = *spin;
    if (!samePose(poses[begin], poses[0]))
      motion.keys = {{0, poses[begin], Easing::linear, EasingDirection::out}};
  } else {
    motion.keys = keysFrom(poses[begin], samples, seconds, true);
  }
  motion.offset = float(double(phase) * kFrame);
  return motion;
}

// A motion that comes once, from its first change on.
Motion onceOf(const std::vector<Pose>& poses, size_t begin, size_t end) {
  Motion motion;
  motion.repeat = Repeat::once;
  const size_t count = end - begin;
  motion.keys = keysFrom(poses[begin], samplesOf(poses, begin, count), double(count) * kFrame, false);
  if (begin > 0) motion.offset = -float(double(begin) * kFrame);
  return motion;
}

}  // namespace

std::optional<Motion> motionOf(const std::vector<Pose>& poses) {
  size_t end = poses.size() - 1;
  while (end > 0 && near(poses[end - 1], poses[end])) --end;
  if (end == 0) return std::nullopt;
  const size_t period = periodOf(poses);
  if (period > 0) return roundOf(poses, beginOf(poses, period), period);
  if (poses.size() - end < 300) return std::nullopt;  // it still moves
  size_t begin = 0;
  while (begin < end && near(poses[begin + 1], poses[begin])) ++begin;
  return onceOf(poses, begin, end);
}

void movingFromObservation(RoleContext& context, const engine::Report& report) {
  const uint32_t frames = report.undisturbed.frames + 1;
  for (const auto& [id, track] : report.undisturbed.tracks) {
    PartDraft* const part = context.part(id);
    if (!part || part->motion || !keepsMoving(report, id)) continue;
    const auto poses = posesOf(track.start, track, 0, frames);
    const std::string reason = lineReason(context.tree, track.line);
    if (const auto motion = motionOf(poses)) {
      giveMotion(context, id, *motion, reason, false);
    } else {
      context.level.noteUnmodelled("motion without a period", context.tree.path(id),
                                   "stays where it is at the start; " + reason);
    }
  }
}

}  // namespace obby::importer
