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

// How far a part may be off its place a round before: a little, and the share of a frame's way by
// which a period that is no whole number of frames is off.
struct Slack {
  float place = kSamePlace, turn = kSameTurn;
};

float turnBetween(const Pose& a, const Pose& b) {
  return std::max(length(a.rotation.x - b.rotation.x), length(a.rotation.y - b.rotation.y));
}

bool near(const Pose& a, const Pose& b, Slack slack = {}) {
  return length(a.position - b.position) < slack.place && turnBetween(a, b) < slack.turn;
}

// Most parts move little in a frame: a jump says nothing about the speed.
Slack slackOf(const std::vector<Pose>& poses) {
  constexpr float kShare = 0.6f, kJump = 2;  // studs
  Slack slack;
  for (size_t i = 1; i < poses.size(); ++i) {
    const float way = length(poses[i].position - poses[i - 1].position);
    const float turn = turnBetween(poses[i], poses[i - 1]);
    if (way > kJump || turn > 0.5f) continue;
    slack.place = std::max(slack.place, kShare * way);
    slack.turn = std::max(slack.turn, kShare * turn);
  }
  return slack;
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

namespace {

struct Round {
  size_t frames = 0;   // the nearest whole number; 0: the poses do not repeat
  double seconds = 0;  // exactly
  size_t begin = 0;    // the first frame from which they repeat
};

bool repeats(const std::vector<Pose>& poses, size_t period, Slack slack) {
  // The last two rounds: far from the start, where scripts still wait.
  for (size_t i = poses.size() - period; i-- > poses.size() - 2 * period;)
    if (!near(poses[i], poses[i + period], slack)) return false;
  return true;
}

double worst(const std::vector<Pose>& poses, size_t period) {
  double most = 0;
  for (size_t i = poses.size() - period; i-- > poses.size() - 2 * period;)
    most = std::max(most, double(length(poses[i].position - poses[i + period].position) +
                                 turnBetween(poses[i], poses[i + period])));
  return most;
}

// The period to a fraction of a frame, by the longest multiple of it that was seen.
double exactPeriod(const std::vector<Pose>& poses, size_t period) {
  double exact = double(period);
  for (size_t rounds = 2; 2 * rounds * period < poses.size(); rounds *= 2) {
    const auto middle = size_t(std::lround(exact * double(rounds)));
    size_t best = middle;
    for (size_t lag = middle - 1; lag <= middle + 1; ++lag)
      if (2 * lag < poses.size() && worst(poses, lag) < worst(poses, best)) best = lag;
    exact = double(best) / double(rounds);
  }
  return exact;
}

bool isStill(const std::vector<Pose>& poses, size_t period) {
  return std::all_of(poses.end() - std::ptrdiff_t(period), poses.end(),
                     [&](const Pose& pose) { return near(pose, poses.back()); });
}

// The smallest period of which two rounds were seen.
Round roundIn(const std::vector<Pose>& poses) {
  const Slack slack = slackOf(poses);
  Round round;
  for (size_t period = 2; 2 * period < poses.size() && round.frames == 0; ++period)
    if (repeats(poses, period, slack) && !isStill(poses, period) &&
        (period > 30 || worst(poses, period) < double(kSamePlace)))
      round.frames = period;
  if (round.frames == 0) return round;
  // A slow motion resembles itself after a few frames: the period is where it resembles itself
  // most.
  size_t best = round.frames;
  for (size_t lag = round.frames; lag < round.frames + round.frames / 4 && 2 * lag < poses.size();
       ++lag)
    if (worst(poses, lag) < worst(poses, best)) best = lag;
  round.frames = best;
  round.seconds = exactPeriod(poses, round.frames) * kFrame;
  round.begin = poses.size() - round.frames;
  while (round.begin > 0 &&
         near(poses[round.begin - 1], poses[round.begin - 1 + round.frames], slack))
    --round.begin;
  return round;
}

std::vector<PoseSample> samplesOf(const std::vector<Pose>& poses, size_t from, size_t count) {
  std::vector<PoseSample> samples;
  for (size_t i = 1; i <= count; ++i) samples.push_back({double(i) * kFrame, poses[from + i]});
  return samples;
}

// The samples at which something has changed: a script that sets a pose every other frame means a
// smooth way.
std::vector<PoseSample> changesIn(const std::vector<PoseSample>& samples, const Pose& start) {
  std::vector<PoseSample> changes;
  const Pose* last = &start;
  for (const PoseSample& sample : samples) {
    if (!(sample.pose.position == last->position) || turnBetween(sample.pose, *last) > 0)
      changes.push_back(sample);
    last = &sample.pose;
  }
  return changes;
}

// A round that goes on for ever.
Motion roundMotion(const std::vector<Pose>& poses, const Round& round) {
  Motion motion;
  const size_t begin = round.begin;
  const double seconds = round.seconds;
  const auto samples = samplesOf(poses, begin, round.frames);
  const double since = std::fmod(double(begin) * kFrame, seconds);
  if (const auto spin = spinFrom(poses[begin], samples, double(round.frames) * kFrame)) {
    motion.spin = *spin;
    if (!samePose(poses[begin], poses[0]))
      motion.keys = {{0, poses[begin], Easing::linear, EasingDirection::out}};
  } else {
    motion.keys = keysFrom(poses[begin], changesIn(samples, poses[begin]), seconds, true);
  }
  if (since > 0) motion.offset = float(seconds - since);
  return motion;
}

// A motion that comes once, from its first change on.
Motion onceOf(const std::vector<Pose>& poses, size_t begin, size_t end) {
  Motion motion;
  motion.repeat = Repeat::once;
  const size_t count = end - begin;
  const auto samples = changesIn(samplesOf(poses, begin, count), poses[begin]);
  motion.keys = keysFrom(poses[begin], samples, double(count) * kFrame, false);
  if (begin > 0) motion.offset = -float(double(begin) * kFrame);
  return motion;
}

}  // namespace

std::optional<Motion> motionOf(const std::vector<Pose>& poses, size_t rest) {
  constexpr Slack kUnmoved = {1e-4f, 1e-4f};
  size_t end = poses.size() - 1;
  while (end > 0 && near(poses[end - 1], poses[end], kUnmoved)) --end;
  if (end == 0) return std::nullopt;
  if (const Round round = roundIn(poses); round.frames > 0) return roundMotion(poses, round);
  if (poses.size() - end < rest) return std::nullopt;  // it still moves
  size_t begin = 0;
  while (begin < end && near(poses[begin + 1], poses[begin], kUnmoved)) ++begin;
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

void movingFromObservation(RoleContext& context, const engine::Report& report) {
  constexpr size_t kRest = 300;  // frames after which it is taken to have stopped
  const uint32_t frames = report.undisturbed.frames + 1;
  for (const auto& [id, track] : report.undisturbed.tracks) {
    PartDraft* const part = context.part(id);
    if (!part || part->motion || !keepsMoving(report, id)) continue;
    const auto poses = posesOf(track.start, track, 0, frames);
    const std::string reason = lineReason(context.tree, moverOf(report.undisturbed, id, track));
    if (auto motion = motionOf(poses, kRest)) {
      motion->carries = track.driver != kNoInstance;
      giveMotion(context, id, *motion, reason, false);
    } else {
      context.level.noteUnmodelled("motion without a period", context.tree.path(id),
                                   "stays where it is at the start; " + reason);
      if (!part->anchored) part->evidence.push_back({"held", reason, false});
      part->anchored = true;
    }
  }
}

}  // namespace obby::importer
