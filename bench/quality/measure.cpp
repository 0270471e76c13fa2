#include "quality/measure.h"

#include <cmath>

#include "math/vec.h"
#include "policy/shipped_policy.h"
#include "solve/improve/improve.h"
#include "solve/methods.h"
#include "solve/query_solver.h"

namespace obby::bench {

namespace {

constexpr uint64_t kMaxSteps = 5'000'000;
constexpr float kMinStep = 0.6f;       // studs in 0.2 s; a slower player has no direction
constexpr float kBackCosine = -0.17f;  // of 100 degrees

Vec3 pointAt(schema::Path::Reader path, uint32_t i) {
  const auto p = path.getPoints()[i];
  return {p.getX(), p.getY(), p.getZ()};
}

void measurePath(schema::Path::Reader path, Quality& q) {
  const uint32_t count = path.getPoints().size();
  for (uint32_t i = 1; i < count; ++i)
    q.length += double(length(pointAt(path, i) - pointAt(path, i - 1)));
  Vec3 before{};
  for (uint32_t i = 2; i < count; i += 2) {
    Vec3 step = pointAt(path, i) - pointAt(path, i - 2);
    step.y = 0;
    if (length(step) < kMinStep) continue;
    if (dot(step, before) < kBackCosine * length(step) * length(before)) ++q.turnsBack;
    before = step;
  }
}

}  // namespace

Quality qualityOf(schema::Trajectory::Reader trajectory) {
  Quality quality;
  quality.ticks = trajectory.getTicks();
  quality.jumps = trajectory.getJumps();
  quality.changes = trajectory.getActions().size();
  measurePath(trajectory.getPath(), quality);
  return quality;
}

std::optional<Quality> measure(const SuiteQuery& query, const solve::Preference* preference,
                               double seconds, ThreadPool& pool) {
  solve::SolverOptions options;
  options.budget.maxSteps = kMaxSteps;
  options.budget.attempts = 0;
  options.method = solve::findMethod("auto");
  options.policy = &policy::shippedPolicy().network;
  options.progressRecords = false;
  options.paths = true;
  options.preference = preference;
  options.improveSteps = uint64_t(seconds * solve::kImproveStepsPerSecond);
  std::optional<Quality> quality;
  const auto write = [&](schema::Record::Reader record) -> Status {
    if (record.isTrajectory() && !quality) {
      quality = qualityOf(record.getTrajectory());
    } else if (record.isResult() && quality) {
      quality->firstSeconds = double(record.getResult().getTiming().getFirstSolution());
      quality->finalSeconds = double(record.getResult().getTiming().getSeconds());
      quality->steps = record.getResult().getSteps();
    }
    return {};
  };
  const auto level = solve::loadLevel(query.level);
  if (!level) return std::nullopt;
  const auto answer =
      solve::solveQuery(*level, query.query.reader().getQuery(), options, pool, {write, {}, {}});
  return answer && answer->verdict == schema::Verdict::SOLVED ? quality : std::nullopt;
}

}  // namespace obby::bench
