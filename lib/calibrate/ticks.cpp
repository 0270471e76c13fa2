#include "calibrate/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace obby::calibrate {

namespace {

constexpr int kRounds = 3;
constexpr size_t kForPairs = 150;  // counts in all: pairs of more take too long

uint32_t countAt(const Objective& objective, const std::vector<double>& point, size_t i) {
  return uint32_t(
      std::lround(valueAt(objective.parameters()[i], point[i]) * objective.controlRate()));
}

// No ticks are what is rounded to none.
double shareOfCount(const Objective& objective, size_t i, uint32_t count) {
  const Parameter& p = objective.parameters()[i];
  return count == 0 ? 0 : shareOf(p, count / objective.controlRate());
}

// Without losses yet.
std::vector<Profile> profilesOf(const Objective& objective) {
  std::vector<Profile> out;
  const double rate = objective.controlRate();
  for (size_t i = 0; i < objective.parameters().size(); ++i) {
    const Parameter& p = objective.parameters()[i];
    if (p.kind != Parameter::Kind::ticks) continue;
    Profile profile{i, {}, {}};
    const bool none = p.lowest * rate < 0.5;
    const auto least = none ? 0u : uint32_t(std::ceil(p.lowest * rate));
    for (uint32_t t = least; t <= p.highest * rate; ++t)
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

// Recordings in which any of these times shows, at the shortest or longest that they can be.
std::vector<Take> telling(const Objective& objective, const std::vector<double>& point,
                          const std::vector<Profile>& profiles) {
  std::vector<Take> out;
  for (const Take& take : objective.takes()) {
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

// Two of the profiles, each with one of its counts; or the same one twice.
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

// How far a choice goes from where the fit began.
double wayOf(const Choice& choice, const std::vector<Profile>& profiles,
             const std::vector<double>& start) {
  double way = 0;
  for (const size_t i : {0, 1}) {
    const Profile& p = profiles[choice.profile[i]];
    way += std::fabs(p.shares[choice.count[i]] - start[p.coordinate]);
  }
  return way;
}

// The delay by quarters of a tick; of alike ones the middle.
bool settleDelay(const Objective& objective, std::vector<double>& point, ThreadPool& pool,
                 uint64_t& evaluations) {
  const size_t at = objective.parameters().size();
  std::vector<double> shares = objective.delayShares(0.25 / objective.controlRate());
  std::vector<double> losses(shares.size());
  pool.run(int(shares.size()), [&](int i) {
    std::vector<double> there = point;
    there[at] = shares[size_t(i)];
    losses[size_t(i)] = objective.loss(there);
  });
  evaluations += shares.size();
  const double least = *std::min_element(losses.begin(), losses.end());
  if (alike(objective.loss(point), least)) return false;
  size_t first = 0, last = 0;
  while (!alike(losses[first], least)) ++first;
  for (last = first; last + 1 < losses.size() && alike(losses[last + 1], least);) ++last;
  point[at] = 0.5 * (shares[first] + shares[last]);
  return true;
}

}  // namespace

Scan scanOf(const Objective& objective, const std::vector<double>& point, Tried tried,
            ThreadPool& pool) {
  Scan out{profilesOf(objective), point, false, 0, 0};
  for (const Profile& p : out.profiles)
    out.best[p.coordinate] =
        shareOfCount(objective, p.coordinate, countAt(objective, point, p.coordinate));
  const std::vector<Choice> choices = choicesOf(out.profiles, tried);
  if (choices.empty()) return out;
  const std::vector<Take> told = telling(objective, point, out.profiles);
  const Objective some = objective.of(told);
  out.frames = some.frames();
  std::vector<double> losses(choices.size());
  pool.run(int(choices.size()), [&](int i) {
    losses[size_t(i)] = some.loss(pointOf(choices[size_t(i)], out.profiles, out.best));
  });
  out.evaluations = choices.size();
  const double least = *std::min_element(losses.begin(), losses.end());
  out.better = !alike(some.loss(point), least);
  const std::vector<double> start = objective.start();
  size_t best = choices.size();
  for (size_t i = 0; i < choices.size(); ++i) {
    for (const size_t k : {0, 1}) {
      double& loss = out.profiles[choices[i].profile[k]].losses[choices[i].count[k]];
      loss = std::min(loss, losses[i]);
    }
    const auto way = [&](size_t c) { return wayOf(choices[c], out.profiles, start); };
    if (alike(losses[i], least) && (best == choices.size() || way(i) < way(best))) best = i;
  }
  out.best = pointOf(choices[best], out.profiles, out.best);
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

bool settle(const Objective& objective, std::vector<double>& point, Tried tried, ThreadPool& pool,
            uint64_t& evaluations) {
  bool fell = false;
  for (int round = 0; round < kRounds; ++round) {
    const bool delayed = settleDelay(objective, point, pool, evaluations);
    Scan scan = scanOf(objective, point, tried, pool);
    evaluations += scan.evaluations;
    point = std::move(scan.best);
    fell |= delayed || scan.better;
    if (!delayed && !scan.better) break;
  }
  return fell;
}

}  // namespace obby::calibrate
