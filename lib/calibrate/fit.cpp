#include "calibrate/fit.h"

#include <algorithm>
#include <cmath>

#include "calibrate/cma_es.h"
#include "calibrate/evidence.h"

namespace obby::calibrate {

namespace {

constexpr double kShows = 1e-3;    // studs that some frame moves by, between a parameter's bounds
constexpr double kKnown = 0.1;     // of the value: an interval within this much of it is of use
constexpr double kNothing = 0.5;   // half an interval, in shares: all that was known before
constexpr double kTied = 0.95;     // correlation
constexpr double kWide = 0.25;     // deviation of a search's first generation, in shares
constexpr double kResting = 1e-5;  // of a search that goes nowhere any more
constexpr double kDeviation = 1.4826;  // of a normal distribution, beside the middle of its sizes
constexpr double kOutside = 4;         // deviations that noise does not explain
constexpr double kFinest = 0.01;       // studs
constexpr double kUnfit = 1e300;       // loss of what was not tried

// Those that change anything that was recorded, at the start or near it.
Result<std::vector<Parameter>> shown(std::span<const Take> takes,
                                     const std::vector<Parameter>& parameters,
                                     schema::PhysicsParams::Reader now,
                                     const ObjectiveSettings& settings) {
  const Objective objective(takes, parameters, now, settings);
  const std::vector<double> start = objective.start();
  OBBY_ASSIGN(const std::vector<float> here, objective.residuals(start));
  std::vector<Parameter> out;
  for (size_t i = 0; i < parameters.size(); ++i) {
    double most = 0;
    for (const double share : {0.15, 0.85}) {
      std::vector<double> point = start;
      point[i] = share;
      const auto there = objective.residuals(point);
      if (!there) continue;  // a body that cannot be
      for (size_t k = 0; k < here.size(); ++k)
        most = std::max(most, std::fabs(double((*there)[k]) - double(here[k])));
    }
    if (most > kShows) out.push_back(parameters[i]);
  }
  return out;
}

struct Best {
  std::vector<double> point;
  double loss;
  uint64_t evaluations;
};

// Restarts begin anywhere, the first of them at the parameters as they are.
void search(const Objective& objective, const FitSettings& settings, ThreadPool& pool,
            const std::atomic<bool>& stop,
            const std::function<void(uint32_t, uint32_t, double)>& progress, Best& best) {
  std::vector<double> losses(settings.population);
  for (uint32_t r = 0; r < settings.restarts; ++r) {
    std::vector<double> mean = best.point;
    Random random(settings.seed, 2 * r);
    if (r > 0)
      for (double& share : mean) share = 0.2 + 0.6 * double(random.unit());
    CmaEs method(mean, kWide, settings.population, settings.seed, 2 * r + 1);
    for (uint32_t g = 0; g < settings.generations && method.spread() > kResting; ++g) {
      const auto& points = method.ask();
      pool.run(int(points.size()), [&](int i) {
        losses[size_t(i)] = stop ? kUnfit : objective.loss(points[size_t(i)]);
      });
      if (stop) return;
      best.evaluations += points.size();
      for (size_t i = 0; i < points.size(); ++i) {
        if (!(losses[i] < best.loss)) continue;
        best.loss = losses[i];
        best.point = points[i];
      }
      method.tell(losses);
      progress(r * settings.generations + g + 1, settings.restarts * settings.generations,
               best.loss);
    }
  }
}

// Studs that the positions are off where the simulator does what was recorded: a middle one of all
// errors, which a window in which something else happened does not move.
Result<double> noiseAt(const Objective& objective, const std::vector<double>& point) {
  OBBY_ASSIGN(const std::vector<float> all, objective.residuals(point));
  std::vector<float> sizes;
  for (size_t i = 0; i < all.size(); ++i) {
    if (i % kResiduals < 3) sizes.push_back(std::fabs(all[i]));
  }
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kDeviation * double(*middle);
}

// What no recording shows stays as it was.
Fitted unseen(const Parameter& p, double before) {
  return {p, before, p.lowest, p.highest, false, before};
}

Fitted fittedOf(const Parameter& p, double before, double share, double half) {
  if (half >= kNothing) return unseen(p, before);
  Fitted out{p,     valueAt(p, share), valueAt(p, share - half), valueAt(p, share + half), false,
             before};
  out.known = std::max(out.high - out.value, out.value - out.low) <= kKnown * out.value;
  return out;
}

}  // namespace

Result<Fit> fit(std::span<const Take> takes, std::vector<Parameter> parameters,
                schema::PhysicsParams::Reader now, const FitSettings& settings, ThreadPool& pool,
                const std::atomic<bool>& stop,
                const std::function<void(uint32_t, uint32_t, double)>& progress) {
  OBBY_ASSIGN(const std::vector<Parameter> seen, shown(takes, parameters, now, settings.objective));
  const Objective brief(takes, seen, now, settings.objective);
  ObjectiveSettings longer = settings.objective;
  longer.windowSeconds = settings.longSeconds;
  Fit out;
  Best best{brief.start(), brief.loss(brief.start()), 1};
  out.lossBefore = brief.loss(best.point);
  search(brief, settings, pool, stop, progress, best);
  out.stopped = stop;
  std::vector<double> point = best.point;
  // Whoever misses a ledge by the noise in one sample tells nothing of slopes.
  OBBY_ASSIGN(const double noise, noiseAt(brief, point));
  longer.near = std::clamp(kOutside * noise, kFinest, settings.objective.near);
  const Objective objective(takes, seen, now, longer);
  for (const Objective* stage : {&brief, &objective}) {
    if (stop) break;
    OBBY_ASSIGN(point, refined(*stage, std::move(point), best.evaluations));
  }
  out.evaluations = best.evaluations;
  out.loss = brief.loss(point);
  out.delay = objective.delayAt(point);
  OBBY_ASSIGN(const Slopes slopes, slopesAt(objective, point));
  const Evidence evidence = evidenceOf(slopes);
  for (size_t i = 0; i < seen.size(); ++i) {
    out.parameters.push_back(
        fittedOf(seen[i], valueOf(now, seen[i].name), point[i], evidence.half[i]));
    for (size_t k = 0; k < i; ++k) {
      const double c = evidence.correlation(Eigen::Index(i), Eigen::Index(k));
      if (std::fabs(c) > kTied) out.tied.push_back({seen[k].name, seen[i].name, c});
    }
  }
  for (const Parameter& p : parameters) {
    const bool is =
        std::any_of(seen.begin(), seen.end(), [&](const Parameter& s) { return s.name == p.name; });
    if (!is) out.parameters.push_back(unseen(p, valueOf(now, p.name)));
  }
  return out;
}

}  // namespace obby::calibrate
