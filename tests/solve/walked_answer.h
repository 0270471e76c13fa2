// A hand-made answer for the verifier to accept or refuse. The player walks along -Z over the
// stepping stones and jumps at their edges. The answer records the simulator's result.
#pragma once

#include "io/json_codec.h"
#include "scenes.h"
#include "sim/rules.h"
#include "solve/verify/verifier.h"

namespace obby::solve {

inline void setRegion(schema::Region::Builder region, Vec3 center, Vec3 size) {
  support::set(region.initPosition(), center);
  support::set(region.initSize(), size);
}

class VerifierTest : public testing::Test {
 protected:
  explicit VerifierTest(LevelBuilder stones = steppingStones())
      : builder(std::move(stones)), level(builder.compile()) {
    record.root().initLevel();
    record.root().setLevel(builder.record());
    auto q = query.root().initQuery();
    q.setId("q");
    setRegion(q.initGoal(), {0, 2, -28}, {8, 4, 8});
  }

  schema::Query::Builder q() { return query.root().getQuery(); }

  // Walks to the goal, and jumps at the edges if `jumping`. The record has the same fields as one
  // from a search.
  schema::Trajectory::Builder makeTrajectory(bool jumping = true) {
    sim::World w = sim::makeWorld(level.view(), level.spawns()[0]);
    auto compiled = level::Query::compile(q().asReader(), level);
    EXPECT_TRUE(compiled) << compiled.error().text();
    const level::QueryView view = compiled->view();
    auto t = trajectory.root().initTrajectory();
    std::vector<sim::Action> actions;
    while (w.outcome == sim::Outcome::running && actions.size() < 400) {
      const float z = w.position.z;
      const bool edge = (z < -7 && z > -9) || (z < -19 && z > -21);
      actions.push_back({0, true, jumping && edge});
      sim::advance(w, nullptr, level.view(), &view, actions.back());
    }
    auto runs = t.initActions(uint32_t(actions.size()));
    for (uint32_t i = 0; i < runs.size(); ++i) {
      runs[i].setWalk(true);
      runs[i].setJump(actions[i].jump);
    }
    t.setQuery("q");
    t.setLevel("test");
    t.setOutcome(schema::Outcome(w.outcome));
    support::set(t.initPosition(), level.spawns()[0].feet);
    t.setTicks(uint32_t(actions.size()));
    t.setJumps(w.jumps);
    t.setWaypoints(w.waypoints);
    t.setVisited(w.visited);
    const int32_t part = w.part == level::kNone ? -1 : int32_t(w.part);
    if (w.outcome == sim::Outcome::avoided) {
      t.setAvoid(part);
    } else {
      t.setPart(part);
    }
    t.setStateHash(sim::stateHash(w));
    return t;
  }

  Status check() {
    return verify(level, record.reader().getLevel(), query.reader().getQuery(),
                  trajectory.reader().getTrajectory());
  }
  void expectWrong(const std::string& field) {
    const Status status = check();
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().path, field) << status.error().text();
  }

  LevelBuilder builder;
  level::Level level;
  io::RecordBuilder record, query, trajectory;
};

}  // namespace obby::solve
