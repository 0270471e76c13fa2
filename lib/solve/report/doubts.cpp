#include "solve/report/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "base/listed.h"
#include "level/collider_runs.h"
#include "level/query_view.h"
#include "sim/targets.h"
#include "solve/report/part_text.h"

namespace obby::solve {

namespace {

using Kinds = std::map<std::string_view, schema::Bearing>;

Kinds kindsOf(schema::Level::Reader level) {
  Kinds kinds;
  for (const auto loss : level.getUnmodelled()) {
    kinds.emplace(std::string_view(loss.getKind().cStr()), loss.getBearing());
  }
  return kinds;
}

// Returns true if losses of this kind may make the game harder. An unlisted kind may, too.
bool isHarder(const Kinds& kinds, std::string_view kind) {
  const auto known = kinds.find(kind);
  return known == kinds.end() || known->second != schema::Bearing::EASIER;
}

std::string_view firstKind(const Kinds& kinds, schema::Part::Reader part) {
  for (const auto kind : part.getDoubts()) {
    if (isHarder(kinds, kind.cStr())) return kind.cStr();
  }
  return {};
}

// Returns a box that encloses the player with all limbs during the course.
Box spaceOf(const level::LevelView& level, const Course& course) {
  constexpr float kAround = 8;  // studs, farther than the arms reach
  Box space{course.at(0).position, course.at(0).position};
  for (const sim::World& world : course.replay.worlds) {
    space.lo = min(space.lo, world.position);
    space.hi = max(space.hi, world.position);
  }
  space.lo -= Vec3{kAround, kAround, kAround};
  space.hi += Vec3{kAround, kAround + level.params.bodyTop, kAround};
  return space;
}

struct DoubtfulCollider {
  uint32_t collider, part;
};

std::vector<DoubtfulCollider> collidersNear(const std::vector<uint32_t>& parts,
                                            const level::LevelView& level, const Box& space) {
  level::ColliderRuns runs(level);
  std::vector<DoubtfulCollider> near;
  for (const uint32_t part : parts) {
    const level::ColliderRun run = runs.of(part);
    for (uint32_t i = run.first; i < run.first + run.count; ++i) {
      const bool moves = (level.bounds[i].flags & level::kHeldElsewhere) != 0;
      if (moves || overlaps(level.bounds[i].box(), space)) near.push_back({i, part});
    }
  }
  return near;
}

// Returns texts like "'Belt' (conveyor that a script changes)".
std::vector<std::string> partTexts(schema::Level::Reader level, const Kinds& kinds,
                                   const std::vector<uint32_t>& parts) {
  constexpr size_t kMax = 3;
  std::vector<std::string> texts;
  for (size_t i = 0; i < parts.size() && i < kMax; ++i) {
    texts.push_back(fmt::format("{} ({})", partText(level, parts[i]),
                                firstKind(kinds, level.getParts()[parts[i]])));
  }
  if (parts.size() > kMax) texts.push_back(fmt::format("{} more", parts.size() - kMax));
  return texts;
}

std::string textOf(schema::Level::Reader level, const Kinds& kinds,
                   const std::vector<uint32_t>& touched, Avoiding avoiding) {
  std::string text;
  if (!touched.empty()) {
    text = fmt::format(" This may differ in the game: the solution uses {}.",
                       listed(partTexts(level, kinds, touched), "and"));
    const char* const them = touched.size() == 1 ? "it" : "them";
    if (avoiding == Avoiding::notFound) {
      text += fmt::format(" No solution without {} was found.", them);
    } else if (avoiding == Avoiding::impossible) {
      text += fmt::format(" No solution exists without {}.", them);
    }
  }
  std::vector<std::string> anywhere;
  for (const auto loss : level.getUnmodelled()) {
    if (loss.getAnywhere() && isHarder(kinds, loss.getKind().cStr())) {
      anywhere.push_back(loss.getKind().cStr());
    }
  }
  if (anywhere.empty()) return text;
  return text + fmt::format(" These are not simulated and may matter anywhere in the place: {}.",
                            listed(anywhere, "and"));
}

}  // namespace

std::vector<uint32_t> doubtfulParts(schema::Level::Reader level) {
  const Kinds kinds = kindsOf(level);
  std::vector<uint32_t> parts;
  const auto all = level.getParts();
  for (uint32_t i = 0; i < all.size(); ++i) {
    if (!firstKind(kinds, all[i]).empty()) parts.push_back(i);
  }
  return parts;
}

bool mayBeEasier(schema::Level::Reader level) {
  for (const auto loss : level.getUnmodelled()) {
    if (loss.getBearing() != schema::Bearing::HARDER) return true;
  }
  return false;
}

std::vector<uint32_t> touchedOf(const std::vector<uint32_t>& parts, const level::LevelView& level,
                                const Course& course, uint32_t lastTick) {
  std::vector<uint32_t> touched;
  std::vector<DoubtfulCollider> left = collidersNear(parts, level, spaceOf(level, course));
  lastTick = std::min(lastTick, course.ticks());
  for (uint32_t t = 0; t <= lastTick && !left.empty(); ++t) {
    const sim::World& world = course.at(t);
    const sim::Limbs limbs = sim::limbsOf(world, level.params);
    const sim::RigidBody* const bodies = course.replay.bodiesAtTick(t).data();
    for (const DoubtfulCollider& c : left) {
      const bool carries = course.carriers[t] == int32_t(c.part);
      if (!carries && !sim::touchesCollider(world, bodies, level, c.collider, limbs)) continue;
      if (std::ranges::find(touched, c.part) == touched.end()) touched.push_back(c.part);
    }
    std::erase_if(left, [&](const DoubtfulCollider& c) {
      return std::ranges::find(touched, c.part) != touched.end();
    });
  }
  return touched;
}

void fillDoubts(schema::Result::Builder result, schema::Level::Reader level,
                const std::vector<uint32_t>& touched, Avoiding avoiding) {
  const Kinds kinds = kindsOf(level);
  std::vector<std::pair<std::string_view, int32_t>> doubts;
  for (const uint32_t part : touched) {
    for (const auto kind : level.getParts()[part].getDoubts()) {
      if (isHarder(kinds, kind.cStr())) doubts.emplace_back(kind.cStr(), int32_t(part));
    }
  }
  for (const auto loss : level.getUnmodelled()) {
    const bool matters = loss.getAnywhere() && isHarder(kinds, loss.getKind().cStr());
    if (matters) doubts.emplace_back(loss.getKind().cStr(), -1);
  }
  if (doubts.empty()) return;
  result.setHolds(false);
  auto list = result.initDoubts(uint32_t(doubts.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    list[i].setKind(doubts[i].first.data());
    list[i].setPart(doubts[i].second);
  }
  result.setReason(result.getReason().cStr() + textOf(level, kinds, touched, avoiding));
}

}  // namespace obby::solve
