#include "calibrate/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace obby::calibrate {

namespace {

constexpr int kTickRounds = 3;
constexpr size_t kForPairs = 150;  // max number of counts for which pairs are tried

uint32_t countAt(const Objective& objective, const std::vector<double>& point, size_t i) {
  return uint32_t(
      std::lround(valueAt(objective.parameters()[i], point[i]) * objective.controlRate()));
}

double shareOfCount(const Objective& objective, size_t i, uint32_t count) {
  return shareOf(objective.parameters()[i], count / objective.controlRate());
}

// Returns a profile without losses for each tick-valued parameter.
std::vector<Profile> profilesOf(const Objective& objective) {
  std::vector<Profile> out;
  const double rate = objective.controlRate();
  for (size_t i = 0; i < objective.parameters().size(); ++i) {
    const Parameter& p = objective.parameters()[i];
    if (p.kind != Parameter::Kind::ticks) continue;
    Profile profile{i, {}, {}};
    const bool none = p.lowest * rate < 0.5;
    const auto min = none ? 0u : uint32_t(std::ceil(p.lowest * rate));
    for (uint32_t t = min; t <= p.highest * rate; ++t)
      profile.shares.push_back(shareOfCount(objective, i, t));
    if (profile.shares.empty()) continue;
    profile.losses.assign(profile.shares.size(), std::numeric_limits<double>::max());
    out.push_back(std::move(profile));
  }
  return out;
}

bool differ(const Result<std::vector<float>>& a, const Result<std::vector<float>>& b) {
  return bool(a) != bool(b) || (a && *a != *b);
}

// Returns the recordings whose residuals change if the tick-valued parameters take any mix of their
// min and max values.
std::vector<Take> decisiveTakes(const Objective& objective, const std::vector<double>& point,
                                const std::vector<Profile>& profiles, const Work& work) {
  std::vector<Take> out;
  for (const Take& take : objective.takes()) {
    if (work.stopped()) break;
    const Objective one = objective.of({&take, 1});
    const auto here = one.residuals(point);
    bool shows = false;
    for (uint32_t corner = 0; corner < 1u << profiles.size() && !shows; ++corner) {
      std::vector<double> there = point;
      for (size_t i = 0; i < profiles.size(); ++i) {
        const Profile& p = profiles[i];
        there[p.coordinate] = corner >> i & 1 ? p.shares.back() : p.shares.front();
      }
      shows = differ(one.residuals(there), here);
    }
    if (shows) out.push_back(take);
  }
  return out;
}

// Two profiles, each with one of its counts; or one profile twice.
struct Choice {
  std::array<size_t, 2> profile, count;
};

std::vector<Choice> choicesOf(const std::vector<Profile>& profiles, Tried tried) {
  std::vector<Choice> out;
  const size_t n = profiles.size();
  size_t counts = 0;
  for (const Profile& p : profiles) counts += p.shares.size();
  const bool pairs = tried == Tried::inPairs && n > 1 && counts <= kForPairs;
  for (size_t a = 0; a < n; ++a) {
    for (size_t i = 0; i < profiles[a].shares.size(); ++i) {
      if (!pairs) out.push_back({{a, a}, {i, i}});
      for (size_t b = a + 1; pairs && b < n; ++b) {
        for (size_t k = 0; k < profiles[b].shares.size(); ++k) out.push_back({{a, b}, {i, k}});
      }
    }
  }
  return out;
}

std::vector<double> pointOf(const Choice& choice, const std::vector<Profile>& profiles,
                            std::vector<double> point) {
  for (const size_t i : {0, 1}) {
    const Profile& p = profiles[choice.profile[i]];
    point[p.coordinate] = p.shares[choice.count[i]];
  }
  return point;
}

// Returns the distance of a choice from the fit's start.
double distanceOf(const Choice& choice, const std::vector<Profile>& profiles,
                  const std::vector<double>& start) {
  double distance = 0;
  for (const size_t i : {0, 1}) {
    const Profile& p = profiles[choice.profile[i]];
    distance += std::fabs(p.shares[choice.count[i]] - start[p.coordinate]);
  }
  return distance;
}

// Returns the loss of each point, or the max double for those skipped after a stop.
std::vector<double> lossesOf(const Objective& objective,
                             const std::vector<std::vector<double>>& points, const Work& work) {
  std::vector<double> losses(points.size(), std::numeric_limits<double>::max());
  work.run(int(points.size()), [&](int i) {
    losses[size_t(i)] = objective.loss(points[size_t(i)]);
    work.account().count(1);
  });
  return losses;
}

// Sets the delay to the best quarter of a tick, or to the middle of equally good ones.
bool settleDelay(const Objective& objective, std::vector<double>& point, const Work& work) {
  const size_t at = objective.parameters().size();
  const std::vector<double> shares = objective.delayShares(0.25 / objective.controlRate());
  std::vector<std::vector<double>> points(shares.size(), point);
  for (size_t i = 0; i < shares.size(); ++i) points[i][at] = shares[i];
  const std::vector<double> losses = lossesOf(objective, points, work);
  if (work.stopped()) return false;
  const double min = *std::min_element(losses.begin(), losses.end());
  if (alike(objective.loss(point), min)) return false;
  size_t first = 0, last = 0;
  while (!alike(losses[first], min)) ++first;
  for (last = first; last + 1 < losses.size() && alike(losses[last + 1], min);) ++last;
  point[at] = 0.5 * (shares[first] + shares[last]);
  return true;
}

}  // namespace

Scan scanOf(const Objective& objective, const std::vector<double>& point, Tried tried,
            const Work& work) {
  Scan out{profilesOf(objective), point, false, 0};
  const std::vector<Choice> choices = choicesOf(out.profiles, tried);
  std::vector<double> whole = point;
  for (const Profile& p : out.profiles)
    whole[p.coordinate] =
        shareOfCount(objective, p.coordinate, countAt(objective, point, p.coordinate));
  if (choices.empty() || work.stopped()) return out;
  const std::vector<Take> decisive = decisiveTakes(objective, point, out.profiles, work);
  const Objective some = objective.of(decisive);
  out.frames = some.frames();
  std::vector<std::vector<double>> points;
  for (const Choice& choice : choices) points.push_back(pointOf(choice, out.profiles, whole));
  const std::vector<double> losses = lossesOf(some, points, work);
  if (work.stopped()) return out;
  const double min = *std::min_element(losses.begin(), losses.end());
  out.better = !alike(some.loss(point), min);
  const std::vector<double> start = objective.start();
  size_t best = choices.size();
  for (size_t i = 0; i < choices.size(); ++i) {
    for (const size_t k : {0, 1}) {
      double& loss = out.profiles[choices[i].profile[k]].losses[choices[i].count[k]];
      loss = std::min(loss, losses[i]);
    }
    const auto distance = [&](size_t c) { return distanceOf(choices[c], out.profiles, start); };
    if (alike(losses[i], min) && (best == choices.size() || distance(i) < distance(best))) best = i;
  }
  out.best = std::move(points[best]);
  return out;
}

std::vector<double> countsAround(const Objective& objective, const std::vector<double>& point,
                                 size_t coordinate) {
  constexpr uint32_t kAround = 2;
  const uint32_t now = countAt(objective, point, coordinate);
  std::vector<double> out;
  for (const Profile& p : profilesOf(objective)) {
    for (size_t i = 0; p.coordinate == coordinate && i < p.shares.size(); ++i) {
      std::vector<double> there = point;
      there[coordinate] = p.shares[i];
      const uint32_t count = countAt(objective, there, coordinate);
      if (count != now && count + kAround >= now && count <= now + kAround)
        out.push_back(p.shares[i]);
    }
  }
  return out;
}

bool settle(const Objective& objective, std::vector<double>& point, Tried tried, const Work& work) {
  bool fell = false;
  for (int round = 0; round < kTickRounds && !work.stopped(); ++round) {
    const bool delayed = settleDelay(objective, point, work);
    Scan scan = scanOf(objective, point, tried, work);
    point = std::move(scan.best);
    fell |= delayed || scan.better;
    if (!delayed && !scan.better) break;
  }
  return fell;
}

}  // namespace obby::calibrate
