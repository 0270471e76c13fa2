#include "solve/proof/pressing.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "solve/proof/body_reach.h"
#include "solve/proof/few_boxes.h"
#include "solve/proof/flight.h"
#include "solve/proof/pass_through.h"
#include "solve/proof/solids.h"

namespace obby::solve {

namespace {

constexpr float kLeastOut = 1;  // studs/s: far through a thin part, however slow it is pressed
constexpr size_t kMostPressingWork = 20'000'000;  // boxes looked at: a tenth of a second or two
constexpr size_t kMostKnown = 16;                 // places in one part that chains lead to
constexpr size_t kLinkWork = 8;                   // boxes: what each link of a chain counts as

float torsoHeight(const Params& p) { return p.bodyTop - p.hipHeight; }

// Whoever is pressed touches both parts. The way out of `low` is the shortest one: sideways past
// `other`, or up. Not above 0: nobody touches both.
float pressDepth(const Params& p, const Box& low, const Box& other) {
  const float x = std::min(low.hi.x - other.lo.x, other.hi.x - low.lo.x);
  const float z = std::min(low.hi.z - other.lo.z, other.hi.z - low.lo.z);
  return std::min(std::min(x, z) + bodyAcross(p), low.hi.y - other.lo.y + torsoHeight(p));
}

Pressing nothingPresses(size_t colliders) {
  Pressing none;
  none.depth.assign(colliders, 0.0f);
  none.presses.assign(colliders, false);
  none.bursts.assign(colliders, false);
  none.chained.assign(colliders, false);
  none.speed.assign(colliders, 0.0f);
  none.around.assign(colliders, Box{});
  return none;
}

class Presser {
 public:
  Presser(const level::LevelView& level, const Solids& solids, const Holding& holds)
      : level_(level),
        holds_(holds),
        solids_(solids),
        known_(level.colliderCount),
        found_(nothingPresses(level.colliderCount)) {}

  // What slides, studs/s.
  void slide(uint32_t slider, float speed) {
    if (!solids_.isSolid(slider) || isTooMuch()) return;
    const Box near = solids_.touching(slider);
    work_ += solids_.find(near, [&](uint32_t part) {
      if (part == slider) return;
      const bool pressed = lift(slider, part), lifted = lift(part, slider);
      if (pressed || lifted) found_.presses[slider] = true;
      // Out of what it presses somebody into they come as far again at once.
      if (putInto(part, slider, std::max(2 * speed, kLeastOut))) {
        found_.bursts[slider] = found_.bursts[part] = true;
      }
    });
    if (!found_.bursts[slider]) return;
    work_ += solids_.find(near, [&](uint32_t floor) {
      if (floor != slider) sink(slider, floor, near);
    });
  }

  // What can have a body in it, all of which is there: somewhere else it holds nobody.
  void hold(uint32_t holder, const Box& body) {
    if (!solids_.isSolid(holder) || isTooMuch()) return;
    if (!overlaps(body, solids_.touching(holder))) return;
    const Box out = solids_.putOut(holder, body);
    const float highest = solids_.box(holder).hi.y + solids_.mostDepth(holder);
    work_ += solids_.find(out, [&](uint32_t part) {
      if (part == holder) return;
      // Put out aside they are not as deep in the next as they are below the top of the first; put
      // out over that, not as deep as they were in it.
      const Box& box = solids_.box(part);
      if ((solids_.isUpright(part) ? box.hi.y - kSlack : box.lo.y) <= highest) deepen(part);
      found_.chained[part] = true;
      follow(part, holder, kAtOnce, solids_.putOut(part, out));
    });
  }

  Pressing take() {
    while (!open_.empty() && !isTooMuch()) {
      const Link link = open_.front();
      open_.pop_front();
      if (!isOutdated(link)) lead(link);
    }
    if (isTooMuch()) giveUp();
    return std::move(found_);
  }

 private:
  // Somebody in the part, all of whose body is there.
  struct Link {
    uint32_t part = level::kNone;
    uint32_t from = level::kNone;  // that puts them into it; none: any of several
    Box where{};
  };

  // What is to be followed counts too: it takes memory.
  bool isTooMuch() const { return work_ + kLinkWork * open_.size() > kMostPressingWork; }

  // Each pushes along the shortest way out of it: of two parts only the lower one pushes up. False:
  // nobody is lifted by `low`.
  bool lift(uint32_t low, uint32_t other) {
    const Box &box = solids_.box(low), &beside = solids_.box(other);
    if ((solids_.isUpright(low) ? box.hi.y - kSlack : box.lo.y) > beside.hi.y) return false;
    const float depth = pressDepth(level_.params, box, beside);
    if (!(depth > 0)) return false;
    found_.depth[low] = std::max(found_.depth[low], depth);
    return true;
  }

  void deepen(uint32_t part) {
    found_.depth[part] = std::max(found_.depth[part], solids_.mostDepth(part));
  }

  // One part alone puts somebody into another. False: it does not.
  bool putInto(uint32_t part, uint32_t from, float speed) {
    const Box where = solids_.putOut(part, solids_.touching(from));
    if (keepApart(part, from, where)) return false;
    follow(part, from, speed, where);
    return true;
  }

  void follow(uint32_t part, uint32_t from, float speed, const Box& where) {
    found_.noteAround(part, speed, where);
    open_.push_back({part, from, where});
  }

  // Whom a high block puts down through the thin floor that it stands on may be in what is below.
  void sink(uint32_t upper, uint32_t floor, const Box& where) {
    if (!solids_.putsDown(upper, floor, where)) return;
    Box below = where;
    below.hi.y = solids_.box(floor).lo.y - kSlack;
    below.lo.y = below.hi.y - level_.params.bodyTop - kSlack;
    if (isNews(floor, below)) open_.push_back({floor, level::kNone, below});
  }

  // Does neither of them put anybody into the other there?
  bool keepApart(uint32_t a, uint32_t b, const Box& where) {
    return solids_.standOnEachOther(a, b, where) && !holdsNear(a, b, where) &&
           !holdsNear(b, a, where);
  }

  // Can a body that is or was held in the one be at the other there?
  bool holdsNear(uint32_t holder, uint32_t other, const Box& where) {
    const Box there = common(where, solids_.touching(other));
    work_ += holds_[holder].size();
    return std::any_of(holds_[holder].begin(), holds_[holder].end(), [&](const Box& body) {
      return overlaps(solids_.putOut(holder, body), there);
    });
  }

  // Out of it into a third part. Who is between three of them can be as deep in each as it goes.
  void lead(const Link& link) {
    work_ += solids_.find(link.where, [&](uint32_t part) {
      if (part == link.part || part == link.from) return;
      if (keepApart(part, link.part, link.where)) {
        sink(link.part, part, link.where);
        return;
      }
      chain(link.part, link.where);
      Box where = solids_.putOut(part, link.where);
      if (!isNews(part, where)) return;
      chain(part, where);
      open_.push_back({part, level::kNone, where});
    });
  }

  // Joined with what is known of its surroundings. False: all of it is known.
  bool isNews(uint32_t part, Box& where) {
    std::vector<Box>& known = known_[part];
    for (const Box& box : known) {
      if (isWithin(where, box)) return false;
    }
    for (Box& box : known) {
      if (!overlaps(box, where)) continue;
      box = where = join(box, where);
      return true;
    }
    where = addBox(known, where, kMostKnown);
    return true;
  }

  // A larger one has come after it, or instead of it.
  bool isOutdated(const Link& link) const {
    if (link.from != level::kNone) return false;
    const std::vector<Box>& known = known_[link.part];
    return std::any_of(known.begin(), known.end(), [&](const Box& box) {
      return isWithin(link.where, box) && !isWithin(box, link.where);
    });
  }

  void chain(uint32_t part, const Box& where) {
    deepen(part);
    found_.chained[part] = true;
    found_.noteAround(part, kAtOnce, where);
  }

  // Too much to look at: any part may put out anybody.
  void giveUp() {
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (!solids_.isSolid(id)) continue;
      chain(id, solids_.touching(id));
      found_.depth[id] = kAnyDepth;
    }
  }

  const level::LevelView& level_;
  const Holding& holds_;
  const Solids& solids_;
  std::vector<std::vector<Box>> known_;  // (colliders): where chains lead to
  std::deque<Link> open_;  // to be followed, the oldest first: later ones have grown meanwhile
  size_t work_ = 0;
  Pressing found_;
};

Pressing pressed(const level::LevelView& level, const Solids& solids,
                 const std::vector<PartMotion>& motions, const Holding& holds) {
  Presser presser(level, solids, holds);
  for (const PartMotion& m : motions) {
    if (m.sideways > 0) presser.slide(m.collider, m.sideways);
  }
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    for (const Box& body : holds[id]) presser.hold(id, body);
  }
  return presser.take();
}

}  // namespace

Pressing pressingOf(const level::LevelView& level, const std::vector<PartMotion>& motions,
                    const Holding& holds, bool mayJump) {
  const bool slides = std::any_of(motions.begin(), motions.end(),
                                  [](const PartMotion& m) { return m.sideways > 0; });
  const bool held = std::any_of(holds.begin(), holds.end(),
                                [](const std::vector<Box>& bodies) { return !bodies.empty(); });
  const bool passes = mayPassThrough(level, mayJump);
  Pressing found = nothingPresses(level.colliderCount);
  if (!slides && !held && !passes) return found;
  const Solids solids(level, motions);
  if (slides || held) found = pressed(level, solids, motions, holds);
  if (passes) passThrough(level, solids, mayJump, found);
  return found;
}

}  // namespace obby::solve
