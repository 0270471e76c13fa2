// A policy is evaluated on all good levels, even if others are bad.
#include "train/evaluate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "train/gaps.h"

namespace obby::train {
namespace {

Evaluation judged(const LevelSource& source, const EvaluationSettings& how, int threads) {
  ThreadPool pool(threads);
  const std::atomic<bool> stop{false};
  return evaluate(policy::Network(), source, how, pool, stop);
}

EvaluationSettings ofLevels(uint32_t levels) {
  EvaluationSettings how;
  how.levels = levels;
  how.tries = 1;
  return how;
}

class SomeBad : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    if (index % 4 == 3) return makeError(fmt::format("level {} is bad", index));
    return Gaps::level(index, hardest);
  }
};

TEST(Evaluation, PlaysTheGoodLevelsAmongBadOnes) {
  for (const int threads : {1, 3}) {
    const Evaluation e = judged(SomeBad(), ofLevels(10), threads);
    EXPECT_EQ(e.levels, 8u) << threads;
    ASSERT_FALSE(e.missing);
    EXPECT_EQ(e.missing.error().text(), "level 3 is bad");
  }
  EXPECT_TRUE(judged(Gaps(), ofLevels(3), 1).missing);
}

TEST(Evaluation, EndsWithItsTimeLimit) {
  EvaluationSettings how = ofLevels(1000);
  how.seconds = 0;
  const Evaluation none = judged(Gaps(), how, 2);
  EXPECT_EQ(none.levels, 0u);
  EXPECT_TRUE(none.timeUp);
  EXPECT_FALSE(judged(Gaps(), ofLevels(3), 2).timeUp);
}

TEST(Evaluation, ReportsItsProgress) {
  for (const int threads : {1, 3}) {
    std::vector<EvaluationSoFar> reports;
    ThreadPool pool(threads);
    const std::atomic<bool> stop{false};
    const Evaluation e = evaluate(policy::Network(), SomeBad(), ofLevels(10), pool, stop,
                                  [&](const EvaluationSoFar& soFar) { reports.push_back(soFar); });
    ASSERT_EQ(reports.size(), 8u) << threads;
    for (uint32_t i = 0; i < reports.size(); ++i) {
      EXPECT_EQ(reports[i].levels, i + 1);
      EXPECT_FLOAT_EQ(float(reports[i].done), float(i + 1) / 10);
    }
    EXPECT_EQ(reports.back().likeliest, e.likeliest);
  }
}

TEST(Evaluation, CountsEachKindOfLevel) {
  const auto kindOf = [](const TrainingLevel& level) { return uint16_t(level.hash() % 3); };
  uint32_t counts[3] = {};
  for (uint64_t i = 0; i < 20; ++i) {
    if (i % 4 != 3) ++counts[kindOf(**Gaps().level(i, 1))];
  }
  EvaluationSettings how = ofLevels(20);
  how.tries = 3;
  const std::atomic<bool> stop{false};
  for (const int threads : {1, 3}) {
    ThreadPool pool(threads);
    const Evaluation e = evaluate(policy::Network(), SomeBad(), how, pool, stop, {}, kindOf);
    double drawn = 0;
    for (size_t kind = 0; kind < 3; ++kind) {
      EXPECT_EQ(kind < e.kinds.size() ? e.kinds[kind].levels : 0, counts[kind]) << kind;
      if (kind < e.kinds.size()) drawn += e.kinds[kind].drawn * e.kinds[kind].levels;
    }
    EXPECT_NEAR(drawn, e.drawn * e.levels, 1e-9);
  }
  const Evaluation all = judged(Gaps(), ofLevels(3), 1);
  ASSERT_EQ(all.kinds.size(), 1u);
  EXPECT_EQ(all.kinds[0].levels, 3u);
}

// Levels that record calls of past().
class Watched : public Gaps {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index, float hardest) const override {
    {
      const std::lock_guard hold(lock_);
      EXPECT_GE(index, past_) << "it was past";
    }
    return Gaps::level(index, hardest);
  }
  void past(uint64_t index) const override {
    const std::lock_guard hold(lock_);
    past_ = std::max(past_, index);
  }
  uint64_t firstLeft() const { return past_; }

 private:
  mutable std::mutex lock_;
  mutable uint64_t past_ = 0;
};

TEST(Evaluation, TellsTheSourceWhichLevelsArePast) {
  for (const int threads : {1, 3}) {
    const Watched levels;
    EvaluationSettings how = ofLevels(12);
    how.firstLevel = 5;
    EXPECT_EQ(judged(levels, how, threads).levels, 12u);
    EXPECT_EQ(levels.firstLeft(), 17u) << threads;
  }
}

// A pit without an exit, and a guide so long that an episode takes minutes.
class Pit : public LevelSource {
 public:
  Result<std::shared_ptr<const TrainingLevel>> level(uint64_t, float) const override {
    support::LevelBuilder b;
    b.block({0, -0.5f, 0}, {20, 1, 20});
    for (const float side : {-10.0f, 10.0f}) {
      b.block({side, 25, 0}, {1, 50, 20});
      b.block({0, 25, side}, {20, 50, 1});
    }
    b.spawn({0, 0, 0});
    capnp::MallocMessageBuilder query;
    auto q = query.initRoot<schema::Query>();
    q.setId("out");
    support::set(q.initGoal().initPosition(), {0, 2, -400});
    support::set(q.getGoal().initSize(), {4, 4, 4});
    auto route = q.initRoute(4000);
    for (uint32_t i = 0; i < route.size(); ++i)
      support::set(route[i], {0, 0, i % 2 == 0 ? 0.0f : -400.0f});
    return TrainingLevel::make(b.record(), q.asReader());
  }
};

TEST(Evaluation, EndsDuringALongEpisode) {
  const auto begin = std::chrono::steady_clock::now();
  EvaluationSettings how = ofLevels(2);
  how.seconds = 0.1;
  const Evaluation late = judged(Pit(), how, 1);
  EXPECT_EQ(late.levels, 0u) << "an abandoned level does not count";
  EXPECT_TRUE(late.timeUp);
  std::atomic<bool> stop{false};
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  ThreadPool pool(1);
  const Evaluation evaluation = evaluate(policy::Network(), Pit(), ofLevels(2), pool, stop);
  stopper.join();
  EXPECT_EQ(evaluation.levels, 0u);
  EXPECT_FALSE(evaluation.timeUp);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

}  // namespace
}  // namespace obby::train
