#include "import/observed/rounds.h"

#include <algorithm>
#include <cmath>

#include "engine/observation.h"

namespace obby::importer {
namespace {

constexpr float kSamePlace = 0.02f;  // studs
constexpr float kSameTurn = 0.01f;   // radians

// Max distance of a part from its pose one round before. It is a small constant, plus the motion in
// the fraction of a frame by which the period differs from a whole number of frames.
struct Slack {
  float place = kSamePlace, turn = kSameTurn;
};

float turnBetween(const Pose& a, const Pose& b) {
  return std::max(length(a.rotation.x - b.rotation.x), length(a.rotation.y - b.rotation.y));
}

bool near(const Pose& a, const Pose& b, Slack slack = {}) {
  return length(a.position - b.position) < slack.place && turnBetween(a, b) < slack.turn;
}

// Returns the slack of each frame, from the fastest of the frames around it. Jumps are left out, as
// they do not show the speed.
std::vector<Slack> slacksOf(const std::vector<Pose>& poses) {
  constexpr float kShare = 0.6f, kJump = 2;  // studs
  constexpr size_t kAround = 4;              // frames; scripts may set poses only now and then
  std::vector<Slack> slacks(poses.size());
  for (size_t i = 1; i < poses.size(); ++i) {
    const float distance = length(poses[i].position - poses[i - 1].position);
    const float turn = turnBetween(poses[i], poses[i - 1]);
    if (distance > kJump || turn > 0.5f) continue;
    const size_t last = std::min(poses.size() - 1, i + kAround);
    for (size_t k = i > kAround ? i - kAround : 0; k <= last; ++k) {
      slacks[k].place = std::max(slacks[k].place, kShare * distance);
      slacks[k].turn = std::max(slacks[k].turn, kShare * turn);
    }
  }
  return slacks;
}

bool isNear(const std::vector<Pose>& poses, const std::vector<Slack>& slacks, size_t i, size_t j) {
  const Slack &a = slacks[i], &b = slacks[j];
  return near(poses[i], poses[j], {std::max(a.place, b.place), std::max(a.turn, b.turn)});
}

bool repeats(const std::vector<Pose>& poses, const std::vector<Slack>& slacks, size_t period) {
  // Compares the last two rounds: scripts may still wait near the start.
  for (size_t i = poses.size() - period; i-- > poses.size() - 2 * period;)
    if (!isNear(poses, slacks, i, i + period)) return false;
  return true;
}

// Returns the max distance of the last `count` poses from the last one.
float extent(const std::vector<Pose>& poses, size_t count) {
  float max = 0;
  for (size_t i = poses.size() - count; i < poses.size(); ++i)
    max = std::max(max, length(poses[i].position - poses.back().position) +
                            turnBetween(poses[i], poses.back()));
  return max;
}

double worst(const std::vector<Pose>& poses, size_t period) {
  double max = 0;
  for (size_t i = poses.size() - period; i-- > poses.size() - 2 * period;)
    max = std::max(max, double(length(poses[i].position - poses[i + period].position) +
                               turnBetween(poses[i], poses[i + period])));
  return max;
}

// Returns the period to a fraction of a frame, from the longest multiple of it in the poses.
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
  const std::vector<Slack> slacks = slacksOf(poses);
  // The end of a settling motion resembles a round, but a small one.
  const float min = extent(poses, poses.size() / 2) / 2;
  Round round;
  for (size_t period = 2; 2 * period < poses.size() && round.frames == 0; ++period)
    if (repeats(poses, slacks, period) && !isStill(poses, period) &&
        (period > 30 || worst(poses, period) < double(kSamePlace)) && extent(poses, period) >= min)
      round.frames = period;
  if (round.frames == 0) return round;
  // A slow motion resembles itself after a few frames. The period is the lag with the best match.
  size_t best = round.frames;
  for (size_t lag = round.frames; lag < round.frames + round.frames / 4 && 2 * lag < poses.size();
       ++lag)
    if (worst(poses, lag) < worst(poses, best)) best = lag;
  round.frames = best;
  round.seconds = exactPeriod(poses, round.frames) * engine::kFrame;
  round.begin = poses.size() - round.frames;
  while (round.begin > 0 && isNear(poses, slacks, round.begin - 1, round.begin - 1 + round.frames))
    --round.begin;
  return round;
}

}  // namespace obby::importer
