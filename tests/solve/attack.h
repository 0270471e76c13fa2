// Attacks on the bound on reach: players in random levels with random physics try to leave the
// bound. Everything is a function of the seed.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "solve/proof/reach_bound.h"
#include "support/level_builder.h"
#include "support/plain_problem.h"

namespace obby::solve {

struct AttackCounts {
  uint64_t levels = 0, unbounded = 0, wild = 0, ticks = 0;
};

class Attack {
 public:
  // `features` adds parts of all shapes that move, vanish, throw and teleport. `tricks` are the
  // tricks that players may use.
  Attack(uint64_t seed, bool features, uint16_t tricks = 0) : random_(seed, 77), tricks_(tricks) {
    const uint32_t kind = features ? random_.below(5) : 9;
    platforms_ = kind == 4;
    tilts_ = kind < 2;
    roles_ = kind > 0 && kind < 4;
    build();
  }

  // Returns a description of a position outside the bound, or nothing if every position was inside.
  std::optional<std::string> run(AttackCounts& counts) {
    auto level = builder_.tryCompile();
    if (!level) return std::nullopt;
    ++counts.levels;
    if (unboundedPart(level->view()) != nullptr) {
      ++counts.unbounded;
      return std::nullopt;
    }
    const bool jumps = random_.below(4) != 0;
    level::QueryView query;
    query.goal.region = {{{0, 50000, 0}, {}}, {1, 1, 1}};
    Problem problem = support::plainProblem(*level, query);
    problem.level.params.tricks = tricks_;
    const ReachBound bound(problem, jumps);
    if (bound.holds({30000, 15000, 0})) {
      ++counts.wild;
      return std::nullopt;
    }
    for (int i = 0; i < 6; ++i) {
      if (auto fault = play(problem, bound, jumps, counts)) return fault;
    }
    return std::nullopt;
  }

  support::LevelBuilder builder() const { return builder_; }

 private:
  float between(float lo, float hi) { return lo + (hi - lo) * random_.unit(); }
  bool oneIn(uint32_t n) { return random_.below(n) == 0; }
  template <class T>
  T anyOf(std::initializer_list<T> of) {
    return of.begin()[random_.below(uint32_t(of.size()))];
  }

  void build() {
    setPhysics();
    const uint32_t parts = 1 + random_.below(oneIn(4) ? 14 : 5);
    const float wide = platforms_ ? 30.0f : anyOf({6.0f, 12.0f, 25.0f}),
                high = anyOf({1.0f, 4.0f, 10.0f});
    const Vec3 floor{between(1, 8), between(0.1f, 4), between(1, 8)};
    builder_.block({0, -0.5f * floor.y, 0}, floor, roleOf({0, -0.5f * floor.y, 0}, true));
    places_.push_back({0, 0, 0});
    for (uint32_t i = 0; i < parts; ++i) addPart(wide, high);
    builder_.spawn({between(-0.5f, 0.5f), oneIn(3) ? between(0, 6) : 0.0f, between(-0.5f, 0.5f)},
                   between(0, 6.28f));
  }

  void addPart(float wide, float high) {
    const Vec3 size{thick(), thick(), thick()};
    Vec3 at{between(-wide, wide), between(-2, high), between(-wide, wide)};
    if (oneIn(3)) at.y = anyOf({0.0f, -0.5f, 2.0f, 3.0f, 7.0f}) - 0.5f * size.y;  // flush tops
    if (oneIn(4)) at.x = places_.back().x;
    places_.push_back(at);
    const float yaw = oneIn(2) ? 0.0f : between(0, 6.28f);
    const float pitch = tilts_ && oneIn(4) ? between(-1.5f, 1.5f) : 0.0f;
    const auto shape = tilts_ && oneIn(3) ? schema::Shape(random_.below(6)) : schema::Shape::BLOCK;
    builder_.block(at, size, [=, role = roleOf(at, false)](schema::Part::Builder p) {
      support::setRotation(p.initRotation(), yaw, pitch);
      p.setShape(shape);
      role(p);
    });
  }

  float thick() { return oneIn(3) ? between(0.05f, 1) : oneIn(5) ? between(8, 30) : between(1, 8); }

  support::LevelBuilder::PartSetter roleOf(Vec3 at, bool calm) {
    const uint32_t role = calm ? 99 : platforms_ ? 7 : roles_ ? random_.below(14) : 99;
    const Vec3 v{between(-30, 30), between(-5, 60), between(-30, 30)};
    const Vec3 to = at + Vec3{between(-8, 8), oneIn(2) ? 0.0f : between(-4, 8), between(-8, 8)};
    const float seconds = between(0.3f, 4), spin = oneIn(3) ? between(-4, 4) : 0.0f;
    const bool carries = oneIn(2), turns = oneIn(2);
    return [=](schema::Part::Builder p) {
      switch (role) {
        case 0:
          support::set(p.initJumpPad().initVelocity(), turns ? Vec3{0, absf(v.y), 0} : v);
          return;
        case 1: support::set(p.initConveyor().initVelocity(), v * 0.5f); return;
        case 2:
          p.initVanish().setTrigger(schema::VanishTrigger::TIMER);
          p.getVanish().setDelay(seconds), p.getVanish().setAway(seconds);
          return;
        case 3: p.initVanish().setDelay(0.2f); return;
        case 4: support::set(p.initTeleport().initPosition(), to); return;
        case 5: p.initBoost().setWalkSpeed(2), p.getBoost().setSeconds(0.5f); return;
        case 12: p.initBoost().setGravity(0.1f * seconds), p.getBoost().setForever(turns); return;
        case 13: p.initBoost().setGravity(seconds), p.getBoost().setSeconds(0.5f); return;
        case 6: p.initOneWay(); return;
        case 7:
        case 8:
        case 9: {
          auto motion = p.initMotion();
          motion.setCarries(carries);
          motion.setRepeat(turns ? schema::Repeat::PING_PONG : schema::Repeat::LOOP);
          auto keys = motion.initKeys(2);
          support::set(keys[0].initPosition(), at);
          support::set(keys[1].initPosition(), to);
          keys[1].setTime(seconds);
          if (spin != 0) motion.initSpin().setSpeed(spin);
          return;
        }
        case 10: p.initFall().setDelay(0.1f), p.getFall().setAway(0.5f); return;
        case 11: p.setFriction(turns ? 0.0f : 2.0f); return;
        default: return;
      }
    };
  }

  void setPhysics() {
    if (oneIn(3)) return;
    const float gravity = anyOf({10.0f, 20.0f, 40.0f, 100.0f, 196.2f, 196.2f, 500.0f});
    const float walk = anyOf({2.0f, 16.0f, 16.0f, 30.0f, 100.0f});
    const float jump = anyOf({0.0f, 3.0f, 10.0f, 20.0f, 30.0f, 53.0f, 53.0f, 100.0f});
    const auto rate = uint16_t(anyOf({30, 60, 60, 120, 240})),
               steps = uint16_t(anyOf({1, 2, 4, 8}));
    const float k = anyOf({200.0f, 1000.0f, 3000.0f, 3000.0f, 8000.0f});
    const float c = anyOf({40.0f, 110.0f, 110.0f, 200.0f, 400.0f});
    const float hip = anyOf({0.5f, 2.0f, 2.0f, 4.0f});
    const float landed = anyOf({0.0f, 0.02f, 0.05f, 0.05f, 0.3f});
    const float coyote = anyOf({0.0f, 0.117f, 0.117f, 0.5f}), grace = anyOf({0.0f, 0.117f, 0.5f});
    const float air = anyOf({0.0f, 20.0f, 143.0f, 143.0f, 2000.0f});
    const float base = anyOf({0.1f, 0.55f, 0.55f, 1.0f}), spread = anyOf({0.0f, 0.4f, 0.4f, 1.0f});
    const float width = anyOf({0.3f, 1.0f, 2.0f, 2.0f, 4.0f}),
                depth = anyOf({0.3f, 1.0f, 1.0f, 2.0f});
    const float limit = anyOf({300.0f, 20000.0f, 20000.0f}),
                turn = anyOf({1.0f, 8.0f, 8.0f, 100.0f});
    const bool body = oneIn(2), legs = oneIn(2);
    builder_.physics([=](schema::PhysicsParams::Builder p) {
      p.setGravity(gravity), p.setWalkSpeed(walk), p.setJumpSpeed(jump), p.setAirAccel(air);
      if (legs) {
        p.setControlRate(rate), p.setSubsteps(steps), p.setHoverStiffness(k), p.setHoverDamping(c);
        p.setHoverLimit(limit), p.setLandedTime(landed), p.setCoyoteTime(coyote);
        p.setOffFloorGrace(grace), p.setFloorReachBase(base);
      }
      if (!body) return;
      p.setHipHeight(hip), p.setHeadBottom(hip + 2), p.setBodyTop(hip + 3);
      p.setFloorRaySpread(spread), p.setBodyWidth(width), p.setBodyDepth(depth),
          p.setTurnSpeed(turn);
    });
  }

  // A player that holds keys for a while: random keys, keys toward a part, or keys that turn fast.
  struct Player {
    Random random;
    uint32_t style, hold, jumpOneIn;
    uint32_t left = 0;
    sim::Action action{};

    sim::Action next(const sim::World& w, const std::vector<Vec3>& places, bool mayJump) {
      if (left == 0) {
        left = 1 + random.below(hold);
        const Vec3 to = places[random.below(uint32_t(places.size()))];
        const Turns toward = headingOf(to.x - w.position.x, to.z - w.position.z);
        action = {Turns(random.next()), random.below(10) != 0, random.below(jumpOneIn) == 0};
        if (style == 1) action.heading = toward;
        if (style == 3) action.heading = Turns(toward + random.below(8192) - 4096);
      }
      --left;
      if (style == 2 && left % 2 == 0) action.heading = Turns(action.heading + 0x4000);
      sim::Action now = action;
      now.jump &= mayJump;
      return now;
    }
  };

  std::optional<std::string> play(const Problem& problem, const ReachBound& bound, bool jumps,
                                  AttackCounts& counts) {
    Player player{Random(random_.next(), random_.next()), random_.below(4), anyOf({3u, 10u, 40u}),
                  anyOf({1u, 2u, 5u})};
    sim::World w = problem.start;
    for (uint32_t t = 0; t < 300 && w.outcome == sim::Outcome::running; ++t, ++counts.ticks) {
      const sim::World before = w;
      sim::advance(w, nullptr, problem.level, nullptr, player.next(w, places_, jumps));
      if ((w.flags & sim::kOverruns) != 0) return std::nullopt;
      const auto at = [&](const char* what) {
        return fmt::format(
            "{}: tick {}, ({}, {}, {}) v ({}, {}, {}) state {}, {} jumps, from y {} state {}{}",
            what, t, w.position.x, w.position.y, w.position.z, w.velocity.x, w.velocity.y,
            w.velocity.z, int(w.state), w.jumps, before.position.y, int(before.state),
            jumps ? "" : ", no jumps");
      };
      if (!bound.holds(w.position)) return at("outside");
      const bool lands = w.state == sim::State::landed && before.state != sim::State::landed;
      if (!lands || w.outcome != sim::Outcome::running) continue;
      level::TargetView here;
      here.region = {{w.position + Vec3{0, 0.01f, 0}, {}}, {0.01f, 0.01f, 0.01f}};
      if (bound.jumpsTo(here) > w.jumps) return at("fewer jumps");
    }
    return std::nullopt;
  }

  Random random_;
  const uint16_t tricks_;
  bool tilts_, roles_, platforms_;
  support::LevelBuilder builder_;
  std::vector<Vec3> places_;
};

}  // namespace obby::solve
