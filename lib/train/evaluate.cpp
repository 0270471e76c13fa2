#include "train/evaluate.h"

#include <algorithm>
#include <mutex>

#include "base/stopwatch.h"

namespace obby::train {

namespace {

constexpr double kGrace = 1;  // seconds for running episodes after time is up

// Decides when to end, even within an episode, because a long one takes minutes.
class Limit {
 public:
  Limit(const std::atomic<bool>& stop, double seconds) : stop_(stop), seconds_(seconds) {}

  bool stopped() const { return stop_; }
  bool timeUp() const { return watch_.seconds() >= seconds_; }
  double share() const { return seconds_ > 0 ? std::min(watch_.seconds() / seconds_, 1.0) : 1; }
  bool over() const { return stop_ || watch_.seconds() >= seconds_ + kGrace; }

 private:
  const std::atomic<bool>& stop_;
  const double seconds_;
  const Stopwatch watch_;
};

// Plays one episode by the policy alone. Returns true if it reaches the goal. `random`: null for
// the greedy policy.
bool playAlone(const policy::NetworkView& network, policy::Observe observe,
               const TrainingLevel& level, Random* random, uint32_t maxTicks, const Limit& limit) {
  const policy::Scene& scene = level.scene();
  float inputs[policy::kInputs];
  sim::World world = level.start();
  std::vector<sim::RigidBody> bodies = level.startBodies();
  for (uint32_t t = 0; t < maxTicks && !limit.over(); t += policy::kDecisionTicks) {
    const Turns ahead = observe(scene, world, bodies.data(), inputs);
    const sim::Action action = policy::decideOn(scene, network, world, inputs, ahead, random);
    for (uint32_t k = 0; k < policy::kDecisionTicks; ++k) {
      sim::advance(world, bodies.data(), scene.level, &scene.query, action);
    }
    if (world.outcome != sim::Outcome::running) return world.outcome == sim::Outcome::goal;
  }
  return false;
}

// The result of a level.
struct Score {
  bool played = false, likeliest = false;
  uint16_t kind = 0;
  uint32_t drawn = 0;  // episodes that solve the level
};

Score scoreOf(const policy::NetworkView& network, const TrainingLevel& level, uint64_t index,
              const EvaluationSettings& settings, const Limit& limit) {
  const uint32_t max = maxTicksOf(level, settings.patience);
  Score score;
  score.likeliest = playAlone(network, settings.observe, level, nullptr, max, limit);
  Random random(settings.seed, index);
  for (uint32_t k = 1; k < settings.tries; ++k)
    score.drawn += playAlone(network, settings.observe, level, &random, max, limit);
  score.played = !limit.over();  // an episode that was given up does not count
  return score;
}

void add(Solved& to, const Score& s, uint32_t tries) {
  ++to.levels;
  to.likeliest += s.likeliest;
  to.drawn += tries > 1 ? double(s.drawn) / (tries - 1) : 0;
  to.any += s.likeliest || s.drawn > 0;
}

void toShares(Solved& sums) {
  for (double* share : {&sums.likeliest, &sums.drawn, &sums.any})
    *share = sums.levels > 0 ? *share / sums.levels : 0;
}

Evaluation sumOf(const std::vector<Score>& scores, uint32_t tries) {
  Evaluation out;
  for (const Score& s : scores) {
    if (!s.played) continue;
    add(out, s, tries);
    if (s.kind >= out.kinds.size()) out.kinds.resize(size_t(s.kind) + 1);
    add(out.kinds[s.kind], s, tries);
  }
  toShares(out);
  for (Solved& kind : out.kinds) toShares(kind);
  return out;
}

// Reports the results of the levels so far.
class Telling {
 public:
  using Watch = std::function<void(const EvaluationSoFar&)>;
  Telling(const Watch& watch, uint32_t levels, const Limit& limit)
      : watch_(watch), levels_(levels), limit_(limit) {}

  void played(const Score& score) {
    if (!watch_) return;
    const std::lock_guard hold(lock_);
    ++played_;
    likeliest_ += score.likeliest;
    watch_({played_, double(likeliest_) / played_,
            std::max(double(played_) / levels_, limit_.share())});
  }

 private:
  const Watch& watch_;
  const uint32_t levels_;
  const Limit& limit_;
  std::mutex lock_;
  uint32_t played_ = 0, likeliest_ = 0;
};

// Requests each level once, from any thread.
class Asking {
 public:
  Asking(const LevelSource& source, const EvaluationSettings& settings)
      : source_(source), settings_(settings), asked_(settings.levels) {}

  // Returns the i-th level, or null if the source returned none or an error.
  std::shared_ptr<const TrainingLevel> level(uint32_t i) {
    auto found = source_.level(settings_.firstLevel + i, settings_.hardest);
    const std::lock_guard hold(lock_);
    drop(i);
    if (found) return *std::move(found);
    if (missing_ || i < firstMissing_) {
      firstMissing_ = i;
      missing_ = std::move(found).error();
    }
    return nullptr;
  }
  const Status& missing() const { return missing_; }  // valid once all threads are done

 private:
  // Threads overtake one another. The source may forget levels before the first pending one.
  void drop(uint32_t i) {
    asked_[i] = true;
    while (next_ < asked_.size() && asked_[next_]) ++next_;
    source_.past(settings_.firstLevel + next_);
  }

  const LevelSource& source_;
  const EvaluationSettings& settings_;
  std::mutex lock_;
  std::vector<bool> asked_;
  size_t next_ = 0;
  uint32_t firstMissing_ = 0;
  Status missing_;  // the error of level firstMissing_
};

}  // namespace

Evaluation evaluate(const policy::Network& network, const LevelSource& source,
                    const EvaluationSettings& settings, ThreadPool& pool,
                    const std::atomic<bool>& stop,
                    const std::function<void(const EvaluationSoFar&)>& watch,
                    const KindOf& kindOf) {
  const Limit limit(stop, settings.seconds);
  const policy::Thinker thinker(network);
  Asking asking(source, settings);
  Telling telling(watch, settings.levels, limit);
  std::vector<Score> scores(settings.levels);
  std::atomic<bool> timeUp = false;
  pool.run(int(settings.levels), [&](int i) {
    if (limit.stopped()) return;
    if (limit.timeUp()) {
      timeUp = true;
      return;
    }
    const auto level = asking.level(uint32_t(i));
    if (!level) return;
    const uint64_t index = settings.firstLevel + uint64_t(i);
    Score& score = scores[size_t(i)];
    score = scoreOf(thinker.view(), *level, index, settings, limit);
    if (kindOf) score.kind = kindOf(*level);
    if (score.played) {
      telling.played(score);
    } else if (!limit.stopped()) {
      timeUp = true;
    }
  });
  Evaluation out = sumOf(scores, settings.tries);
  out.timeUp = timeUp;
  out.missing = asking.missing();
  return out;
}

}  // namespace obby::train
