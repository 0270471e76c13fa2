#include "solve/proof/contacts.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr size_t kMostWork = 4'000'000;  // parts looked at; from then on all are deep

// Sideways from its middle to its nearest face, at most.
float leastHalf(const Box& box) {
  const Vec3 size = box.hi - box.lo;
  return 0.5f * std::min({size.x, size.y, size.z});
}

}  // namespace

Contacts::Contacts(const level::LevelView& level, const BodyLimits& limits,
                   const std::vector<PartMotion>& motions, const std::vector<Vec3>& appear)
    : level_(level),
      limits_(limits),
      motions_(motions),
      beside_(level.colliderCount, Beside::clear),
      pressed_(level.colliderCount),
      index_(solidBoxes()) {
  spreadDeep(appear);
  findPinched();
}

std::vector<Box> Contacts::solidBoxes() {
  std::vector<Box> boxes;
  for (uint32_t id = 0; id < level_.colliderCount; ++id) {
    if (!(level_.bounds[id].flags & level::kSolid)) continue;
    solids_.push_back(id);
    boxes.push_back(motions_[id].swept);
  }
  return boxes;
}

// Can a body be inside of it without having been pressed there?
bool Contacts::isRough(uint32_t id) const {
  constexpr uint32_t kChanges =
      level::kMoving | level::kVanishTimer | level::kClocked | level::kOneWay;
  return (level_.bounds[id].flags & kChanges) != 0;
}

// A part that a body is pressed into may put it out into the next one. A part that is thicker than
// the push pushes back; one that is thinner may push on, from where it was met.
void Contacts::spreadFrom(Box where, float push) {
  const Params& p = limits_.params();
  std::vector<std::pair<Box, float>> open{{where, push}};
  while (!open.empty() && work_ <= kMostWork) {
    const Box from = open.back().first;
    const float by = open.back().second;
    open.pop_back();
    const float far = limits_.across + 2 * by;
    const Box region = grow(from, {far, p.bodyTop + 2 * by, far});
    find(region, [&](uint32_t id) {
      ++work_;
      const bool known = beside_[id] == Beside::deep;
      beside_[id] = Beside::deep;
      const Box& box = motions_[id].swept;
      const float half = leastHalf(box);
      if (half > by + limits_.body) return;
      const Box met{max(box.lo, region.lo), min(box.hi, region.hi)};
      if (known && isWithin(met, pressed_[id])) return;
      pressed_[id] = known ? join(pressed_[id], met) : met;
      open.emplace_back(pressed_[id], half + limits_.body + 1);
    });
  }
}

bool Contacts::movesAlone(uint32_t id) const {
  constexpr uint32_t kOther =
      level::kVanishTimer | level::kClocked | level::kOneWay | level::kTriggered;
  const uint32_t flags = level_.bounds[id].flags;
  const PartMotion& m = motions_[id];
  const Params& p = limits_.params();
  // The head alone, as a jump begins, does not pass through one that comes down.
  const float upward = (limits_.jump + m.upward) * p.substepSeconds + m.vertical * p.tickSeconds;
  const bool slow = m.step < 0.25f * std::min(p.bodyWidth, p.bodyDepth) &&
                    upward < 0.45f * (p.bodyTop - p.headBottom);
  if (!(flags & level::kUpright) || (flags & kOther) || !slow) return false;
  const float far = limits_.across + 2 * m.step;
  bool alone = true;
  find(grow(m.swept, {far, p.bodyTop, far}), [&](uint32_t other) { alone &= other == id; });
  return alone;
}

void Contacts::spreadDeep(const std::vector<Vec3>& appear) {
  std::vector<bool> seeds(level_.colliderCount);
  // A part that moves alone pushes a body that nothing else holds.
  for (const uint32_t id : solids_) seeds[id] = isRough(id) && !movesAlone(id);
  const Params& p = limits_.params();
  for (const Vec3 feet : appear) {
    const float side = limits_.body;
    const Box torso{feet + Vec3{-side, p.hipHeight + 2 * limits_.slack, -side},
                    feet + Vec3{side, p.bodyTop, side}};
    find(torso, [&](uint32_t id) { seeds[id] = true; });
  }
  for (const uint32_t id : solids_) {
    if (!seeds[id]) continue;
    const float inside = leastHalf({{}, 2.0f * level_.colliders[id].shape.half});
    beside_[id] = Beside::deep;
    spreadFrom(motions_[id].swept, motions_[id].step + inside + limits_.body + 1);
  }
  if (work_ <= kMostWork) return;
  for (const uint32_t id : solids_) beside_[id] = Beside::deep;
}

// Does it stand along the axes of the world?
bool Contacts::isAxial(uint32_t id) const {
  if (!(level_.bounds[id].flags & level::kUpright)) return false;
  const Vec3 x = level_.colliders[id].pose.rotation.x;
  return std::min(absf(x.x), absf(x.z)) < 1e-5f;
}

// Is there a place where both of them hold a body, from opposite sides?
bool Contacts::holdsBetween(uint32_t a, uint32_t b) const {
  if (!isAxial(a) || !isAxial(b)) return true;
  const Params& p = limits_.params();
  const float fits = std::min(p.bodyWidth, p.bodyDepth) - 4 * limits_.slack - 0.1f;
  return gapBetween(motions_[a].swept, motions_[b].swept) > fits;
}

void Contacts::findPinched() {
  const Params& p = limits_.params();
  const bool all = limits_.overlap >= limits_.turned;
  const float torso = p.bodyTop - p.hipHeight + limits_.slack;
  for (const uint32_t id : solids_) {
    if (beside_[id] == Beside::deep) continue;
    bool pinched = all;
    const Box around = grow(motions_[id].swept, {limits_.across, torso, limits_.across});
    if (!pinched) {
      find(around, [&](uint32_t other) {
        pinched |= other != id && work_ < kMostWork && holdsBetween(id, other);
        ++work_;
      });
    }
    if (pinched || work_ >= kMostWork) beside_[id] = Beside::pinched;
  }
}

}  // namespace obby::solve
