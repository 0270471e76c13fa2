#include "import/observed/rounds.h"

#include <algorithm>
#include <cmath>

#include "import/frame_time.h"

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

}  // namespace

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

}  // namespace obby::importer
