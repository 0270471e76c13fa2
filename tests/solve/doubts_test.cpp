// Solutions that depend on doubtful parts, and how answers report this.
#include <gtest/gtest.h>

#include <optional>

#include "scenes.h"
#include "solve/methods.h"

namespace obby::solve {
namespace {

constexpr const char* kDoubtKind = "conveyor that a script changes";

struct Answered {
  schema::Result::Reader result() const { return record->reader().getResult(); }
  std::string reason() const { return result().getReason(); }
  std::vector<int32_t> doubtful, route;  // fields of the first solution
  std::optional<io::Record> record;
};

class DoubtfulLevel : public LevelBuilder {
 public:
  DoubtfulLevel() {
    physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-40); });
    spawn({0, 0, 0});
  }
  void block(Vec3 at, Vec3 size, std::vector<const char*> doubts = {}) {
    LevelBuilder::block(at, size, [doubts](schema::Part::Builder part) {
      auto list = part.initDoubts(uint32_t(doubts.size()));
      for (uint32_t i = 0; i < list.size(); ++i) list.set(i, doubts[i]);
    });
  }
  void loss(const char* kind, schema::Bearing bearing, bool anywhere) {
    losses_.push_back({kind, bearing, anywhere});
  }
  // Solves the query for a goal region of 8 x 4 x 8 studs around `goal`.
  Answered solve(Vec3 goal, std::vector<const char*> bodies = {}) {
    io::RecordBuilder level;
    level.root().setLevel(record());
    auto list = level.root().getLevel().initUnmodelled(uint32_t(losses_.size()));
    for (uint32_t i = 0; i < list.size(); ++i) {
      list[i].setKind(losses_[i].kind);
      list[i].setCount(1);
      list[i].setBearing(losses_[i].bearing);
      list[i].setAnywhere(losses_[i].anywhere);
    }
    const auto loaded = loadLevel(io::Record(std::move(level)));
    EXPECT_TRUE(loaded) << loaded.error().text();
    io::RecordBuilder query;
    auto region = query.root().initQuery().initGoal();
    support::set(region.initPosition(), goal);
    support::set(region.initSize(), {8, 4, 8});
    auto asked = query.root().getQuery().initBodies(uint32_t(bodies.size()));
    for (uint32_t i = 0; i < asked.size(); ++i) asked.set(i, bodies[i]);
    SolverOptions options;
    options.method = findMethod("auto");
    options.budget.maxSteps = 2'000'000;
    options.progressRecords = false;
    ThreadPool pool(1);
    Answered answered;
    const auto write = [&](schema::Record::Reader record) -> Status {
      if (record.isTrajectory() && record.getTrajectory().getIndex() == 0) {
        for (const int32_t p : record.getTrajectory().getDoubtful()) answered.doubtful.push_back(p);
        for (const int32_t p : record.getTrajectory().getRoute()) answered.route.push_back(p);
      }
      if (record.isResult()) answered.record = io::Record(io::RecordBuilder(record));
      return {};
    };
    const auto done =
        solveQuery(*loaded, query.reader().getQuery(), options, {pool, nullptr}, {write, {}, {}});
    EXPECT_TRUE(done) << done.error().text();
    return answered;
  }

 private:
  struct Loss {
    const char* kind;
    schema::Bearing bearing;
    bool anywhere;
  };
  std::vector<Loss> losses_;
};

constexpr Vec3 kBehindTheStone{0, 2, -28};

// Returns a level whose middle stone, between start and goal, the importer marked as doubtful.
DoubtfulLevel stoneInDoubt() {
  DoubtfulLevel level;
  level.block({0, -0.5f, 0}, {8, 1, 8});
  level.block({0, -0.5f, -28}, {8, 1, 8});
  level.block({0, -0.5f, -14}, {8, 1, 6}, {kDoubtKind});
  level.loss(kDoubtKind, schema::Bearing::EITHER, false);
  return level;
}

TEST(Doubts, ASolutionThatNeedsADoubtfulPartDoesNotHold) {
  const Answered answered = stoneInDoubt().solve(kBehindTheStone);
  EXPECT_EQ(answered.result().getVerdict(), schema::Verdict::SOLVED);
  EXPECT_FALSE(answered.result().getHolds());
  ASSERT_EQ(answered.result().getDoubts().size(), 1u);
  EXPECT_EQ(answered.result().getDoubts()[0].getPart(), 2);
  EXPECT_STREQ(answered.result().getDoubts()[0].getKind().cStr(), kDoubtKind);
  EXPECT_EQ(answered.doubtful, std::vector<int32_t>{2});
  EXPECT_NE(answered.reason().find("it uses part 2 (conveyor that a script changes)"),
            std::string::npos)
      << answered.reason();
  EXPECT_NE(answered.reason().find("There is none without it."), std::string::npos)
      << answered.reason();
}

TEST(Doubts, ALongerRouteWithoutThePartIsPreferred) {
  DoubtfulLevel level = stoneInDoubt();
  level.block({10, -0.5f, -2}, {10, 1, 4});
  level.block({14, -0.5f, -15}, {4, 1, 28});
  level.block({10, -0.5f, -28}, {10, 1, 4});
  const Answered answered = level.solve(kBehindTheStone);
  EXPECT_TRUE(answered.result().getHolds()) << answered.reason();
  EXPECT_EQ(answered.result().getDoubts().size(), 0u);
  EXPECT_EQ(answered.doubtful, std::vector<int32_t>{});
  EXPECT_EQ(std::ranges::count(answered.route, 2), 0);
}

TEST(Doubts, NearbyPartsCauseNoDoubt) {
  DoubtfulLevel level;
  level.block({0, -0.5f, -14}, {8, 1, 36});
  level.block({20, -0.5f, -14}, {8, 1, 36}, {kDoubtKind});
  level.loss(kDoubtKind, schema::Bearing::EITHER, false);
  EXPECT_TRUE(level.solve(kBehindTheStone).result().getHolds());
}

TEST(Doubts, ThePartThatThePlayerStartsOnIsNamed) {
  DoubtfulLevel level;
  level.block({0, -0.5f, -14}, {8, 1, 36}, {kDoubtKind});
  level.loss(kDoubtKind, schema::Bearing::EITHER, false);
  const Answered answered = level.solve(kBehindTheStone);
  EXPECT_FALSE(answered.result().getHolds());
  EXPECT_EQ(answered.doubtful, std::vector<int32_t>{0});
}

TEST(Doubts, LossesThatOnlyHelpCauseNoDoubt) {
  DoubtfulLevel level;
  level.block({0, -0.5f, -14}, {8, 1, 36}, {"tool"});
  level.loss("tool", schema::Bearing::EASIER, true);
  EXPECT_TRUE(level.solve(kBehindTheStone).result().getHolds());
}

TEST(Doubts, LossesWithoutAPartConcernAllAnswers) {
  DoubtfulLevel level;
  level.block({0, -0.5f, -14}, {8, 1, 36});
  level.loss("script that fails", schema::Bearing::EITHER, true);
  const Answered answered = level.solve(kBehindTheStone);
  EXPECT_FALSE(answered.result().getHolds());
  ASSERT_EQ(answered.result().getDoubts().size(), 1u);
  EXPECT_EQ(answered.result().getDoubts()[0].getPart(), -1);
  EXPECT_NE(answered.reason().find("may matter anywhere: script that fails."), std::string::npos)
      << answered.reason();
}

TEST(Doubts, AnAnswerForSeveralBodiesHoldsIfEachDoes) {
  const Answered answered = stoneInDoubt().solve(kBehindTheStone, {"r6", "r15"});
  EXPECT_EQ(answered.result().getVerdict(), schema::Verdict::SOLVED);
  EXPECT_FALSE(answered.result().getHolds());
  EXPECT_EQ(answered.result().getDoubts().size(), 1u);
  DoubtfulLevel apart = stoneInDoubt();
  const Answered unsolved = apart.solve({0, 2, -90}, {"r6", "r15"});
  EXPECT_NE(unsolved.result().getVerdict(), schema::Verdict::SOLVED);
  EXPECT_TRUE(unsolved.result().getHolds());
}

// If a loss may help the player elsewhere, it is unknown whether the part is needed.
TEST(Doubts, NoPartIsProvedNecessaryIfAnotherLossMayHelp) {
  DoubtfulLevel level = stoneInDoubt();
  level.loss("water", schema::Bearing::EITHER, true);
  const Answered answered = level.solve(kBehindTheStone);
  EXPECT_EQ(answered.reason().find("There is none"), std::string::npos) << answered.reason();
  EXPECT_NE(answered.reason().find("No solution without it was found."), std::string::npos)
      << answered.reason();
}

// A loss that only hinders the player cannot make the goal reachable.
TEST(Doubts, UnreachableHoldsIfALossCanOnlyHinder) {
  for (const auto bearing :
       {schema::Bearing::EITHER, schema::Bearing::EASIER, schema::Bearing::HARDER}) {
    DoubtfulLevel level;
    level.block({0, -0.5f, 0}, {8, 1, 8});
    level.block({0, -0.5f, -48}, {8, 1, 8});
    level.loss("harm without a touch", bearing, true);
    const Answered answered = level.solve({0, 2, -48});
    const bool shown = bearing == schema::Bearing::HARDER;
    EXPECT_EQ(answered.result().getVerdict() == schema::Verdict::UNREACHABLE, shown);
    EXPECT_TRUE(answered.result().getHolds());
  }
}

}  // namespace
}  // namespace obby::solve
