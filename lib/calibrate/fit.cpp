#include "calibrate/fit.h"

#include <algorithm>
#include <limits>

#include "calibrate/cma_es.h"
#include "calibrate/crossing.h"
#include "calibrate/evidence.h"
#include "calibrate/found.h"
#include "calibrate/instants.h"
#include "calibrate/noise.h"
#include "calibrate/ticks.h"

namespace obby::calibrate {

namespace {

constexpr double kWide = 0.25;             // deviation of a search's first generation, in shares
constexpr double kNarrow[] = {0.1, 0.03};  // of those that go on from what another found, in turn
constexpr double kGain = 0.02;             // share of the loss that makes another worth its time
constexpr double kResting = 1e-5;          // of a search that goes nowhere any more
constexpr uint32_t kLooks = 10;            // generations after which the tolerance is looked at
constexpr int kSlopeRounds = 12;
constexpr int kEventRounds = 3;
constexpr int kDelayRounds = 6;      // accelerations have far to go
constexpr int kRounds = 4;           // of refining what has slopes and what counts in ticks
constexpr int kPasses = 6;           // searches at most, the first with its restarts counted once
constexpr double kOutside = 4;       // deviations that noise does not explain
constexpr double kFinest = 0.01;     // studs
constexpr double kNoLoss = 1e-6;     // studs^2: less than any recorder shows
constexpr double kUnfit = 1e300;     // loss of what was not tried
constexpr uint32_t kMostRate = 480;  // rules a second: the most that levels admit

// Everything that one fit needs, from its beginning to its end.
class Fitter {
 public:
  Fitter(std::span<const Take> takes, std::vector<Parameter> parameters,
         schema::PhysicsParams::Reader now, const FitSettings& settings, ThreadPool& pool,
         const std::atomic<bool>& stop, const std::function<void(uint32_t, uint32_t, double)>& tell)
      : parameters_(std::move(parameters)),
        now_(now),
        settings_(settings),
        pool_(pool),
        stop_(stop),
        progress_(tell),
        brief_(takes, {}, now, settings.objective),
        sharp_(brief_.of(std::vector<Parameter>())) {
    found_.values.root().setParams(now);
  }

  Result<Fit> run() {
    Fit out;
    OBBY_RETURN_IF_ERROR(look());
    out.lossBefore = lossNow();
    OBBY_RETURN_IF_ERROR(approach());
    out.stopped = stop_;
    OBBY_RETURN_IF_ERROR(focus());
    OBBY_RETURN_IF_ERROR(quicken());
    OBBY_RETURN_IF_ERROR(sharpen(settings_.longSeconds));
    if (!stop_) {
      OBBY_RETURN_IF_ERROR(refine(sharp_));
      OBBY_RETURN_IF_ERROR(cross(sharp_));
      OBBY_RETURN_IF_ERROR(forget());
    }
    const Objective objective = sharp_.of(seen_);
    OBBY_ASSIGN(Findings findings, findingsOf(objective, found_.in(objective), parameters_, now_,
                                              found_.params(), pool_, stop_));
    out.parameters = std::move(findings.parameters);
    out.tied = std::move(findings.tied);
    out.evaluations = evaluations_;
    out.loss = lossNow();
    out.delay = found_.delay;
    out.controlRate = found_.params().getControlRate();
    out.substeps = found_.params().getSubsteps();
    return out;
  }

 private:
  double lossNow() const {
    const Objective objective = brief_.of(seen_);
    return objective.loss(found_.in(objective));
  }

  // By short windows, in searches each of which goes on from the one before: a parameter may show
  // only where others have been found, and another place in a crossing gives a search new ways.
  // Within the tolerance nothing is searched any more, only refined.
  Status approach() {
    double before = std::numeric_limits<double>::max();
    for (int pass = 0; pass < kPasses; ++pass) {
      OBBY_RETURN_IF_ERROR(search(pass));
      if (stop_) break;
      OBBY_RETURN_IF_ERROR(refine(brief_));
      OBBY_RETURN_IF_ERROR(cross(brief_));
      const size_t known = seen_.size();
      OBBY_RETURN_IF_ERROR(look());
      OBBY_ASSIGN(reached_, within());
      const double now = lossNow();
      const bool gained = pass == 0 || seen_.size() > known || now < (1 - kGain) * before;
      if (now < kNoLoss || !gained) break;
      before = now;
    }
    return {};
  }

  // By the same windows, but so that those count most in which the simulator does what was
  // recorded: others pull at slopes that they know nothing of, until what happens in them is right,
  // too.
  Status focus() {
    for (int round = 0; round < kRounds && !stop_; ++round) {
      const double before = lossNow();
      OBBY_RETURN_IF_ERROR(sharpen(settings_.objective.windowSeconds));
      OBBY_RETURN_IF_ERROR(refine(sharp_));
      OBBY_RETURN_IF_ERROR(cross(sharp_));
      if (lossNow() > (1 - kGain) * before) break;
    }
    return {};
  }

  // Some engines run the character's rules in each step of their physics, not once a frame: then
  // who holds jump leaves at a step. Kept if it comes nearer; not tried where noise explains what
  // is left (it leaves half of its square), since it takes as long as
  // all that came before.
  Status quicken() {
    const uint32_t substeps = now_.getSubsteps(), rate = now_.getControlRate() * substeps;
    const double before = lossNow(), noise = noiseOf(brief_.takes());
    if (stop_ || substeps <= 1 || rate > kMostRate || before < std::max(kNoLoss, noise * noise))
      return {};
    Found kept{io::RecordBuilder(found_.values.reader()), found_.delay};
    found_.setRate(rate, 1);
    begin();
    OBBY_RETURN_IF_ERROR(sharpen(settings_.objective.windowSeconds));
    OBBY_RETURN_IF_ERROR(refine(sharp_));
    OBBY_RETURN_IF_ERROR(cross(sharp_));
    if (lossNow() < (1 - kGain) * before) return {};
    found_ = std::move(kept);
    begin();
    return {};
  }

  // Objectives at the rate that is found.
  void begin() {
    brief_ = Objective(brief_.takes(), {}, found_.params(), settings_.objective);
    sharp_ = brief_.of(std::vector<Parameter>());
  }

  // Whoever misses a ledge by the noise in one sample tells nothing of slopes.
  Status sharpen(double windowSeconds) {
    const Objective objective = brief_.of(seen_);
    OBBY_ASSIGN(const double noise, noiseAt(objective, found_.in(objective)));
    ObjectiveSettings settings = settings_.objective;
    settings.windowSeconds = windowSeconds;
    settings.near = std::clamp(kOutside * noise, kFinest, settings.near);
    sharp_ = Objective(brief_.takes(), {}, found_.params(), settings);
    return {};
  }

  // Adds the parameters that show beside what is found.
  Status look() {
    const Objective all = brief_.of(parameters_);
    const std::vector<double> point = found_.in(all);
    OBBY_ASSIGN(const std::vector<float> here, all.residuals(point));
    for (size_t i = 0; i < parameters_.size(); ++i) {
      const bool is = std::any_of(seen_.begin(), seen_.end(), [&](const Parameter& s) {
        return s.name == parameters_[i].name;
      });
      if (!is && shows(all, point, i, here)) seen_.push_back(parameters_[i]);
    }
    return {};
  }

  // The first pass: restarts begin anywhere, the first of them at the parameters as they are. Those
  // after it go on once from what is found.
  Status search(int pass) {
    const Objective objective = brief_.of(seen_);
    std::vector<double> best = found_.in(objective);
    double loss = objective.loss(best);
    const uint32_t restarts = pass == 0 ? settings_.restarts : 1;
    for (uint32_t r = 0; r < restarts && !stop_ && !reached_; ++r) {
      std::vector<double> mean = best;
      const uint64_t stream = 2 * (r + uint64_t(pass) * settings_.restarts);
      Random random(settings_.seed, stream);
      if (r > 0)
        for (double& share : mean) share = 0.2 + 0.6 * double(random.unit());
      CmaEs method(mean, pass == 0 ? kWide : kNarrow[pass % 2], settings_.population,
                   settings_.seed, stream + 1);
      const uint32_t number = pass == 0 ? r : settings_.restarts + uint32_t(pass) - 1;
      OBBY_RETURN_IF_ERROR(descend(objective, method, number, best, loss));
    }
    found_.take(objective, best);
    return {};
  }

  // `number`: of searches before.
  Status descend(const Objective& objective, CmaEs& method, uint32_t number,
                 std::vector<double>& best, double& loss) {
    const uint32_t all = (settings_.restarts + kPasses - 1) * settings_.generations;
    std::vector<double> losses(settings_.population);
    for (uint32_t g = 0; g < settings_.generations; ++g) {
      if (method.spread() < kResting || loss < kNoLoss) break;
      const auto& points = method.ask();
      pool_.run(int(points.size()), [&](int i) {
        losses[size_t(i)] = stop_ ? kUnfit : objective.loss(points[size_t(i)]);
      });
      if (stop_) return {};
      evaluations_ += points.size();
      for (size_t i = 0; i < points.size(); ++i) {
        if (!(losses[i] < loss)) continue;
        loss = losses[i];
        best = points[i];
      }
      method.tell(losses);
      progress_(number * settings_.generations + g + 1, all, loss);
      if ((g + 1) % kLooks != 0) continue;
      found_.take(objective, best);
      OBBY_ASSIGN(reached_, within());
      if (reached_) break;
    }
    return {};
  }

  // What is found is within the tolerance.
  Result<bool> within() const {
    if (settings_.tolerance <= 0) return false;
    const auto takes = settings_.heldOut.empty() ? brief_.takes() : settings_.heldOut;
    double sum = 0;
    for (const Take& take : takes) {
      OBBY_ASSIGN(const Path path, pathOf(take, found_.params(), found_.delay));
      sum += missOf(path).mean;
      if (sum > settings_.tolerance * double(takes.size())) return false;
    }
    return true;
  }

  // By slopes, and by whole ticks where there are none, in turn as long as it helps.
  Status refine(const Objective& plain) {
    const Objective objective = plain.of(seen_);
    std::vector<double> point = found_.in(objective);
    settle(objective, point, Tried::singly, pool_, evaluations_);
    for (int round = 0; round < kRounds && !stop_; ++round) {
      OBBY_ASSIGN(point, refined(objective, std::move(point), kSlopeRounds, evaluations_, &pool_));
      if (!settle(objective, point, Tried::singly, pool_, evaluations_)) break;
    }
    found_.take(objective, point);
    return {};
  }

  // Over the leaps of what decides events, and of pairs of times.
  Status cross(const Objective& plain) {
    const Objective objective = plain.of(seen_);
    const std::vector<double> delays = delaysAround(objective, found_.in(objective)[seen_.size()]);
    if (!stop_) crossBy(objective, seen_.size(), delays, kDelayRounds);
    for (size_t i = 0; i < seen_.size() && !stop_; ++i) {
      const Parameter::Kind kind = seen_[i].kind;
      if (kind == Parameter::Kind::smooth) continue;
      if (kind == Parameter::Kind::ticks) {
        const auto counts = countsAround(objective, found_.in(objective), i);
        crossBy(objective, i, counts, kSlopeRounds);
        continue;
      }
      crossBy(objective, i, sharesAllOver(), kEventRounds);
      crossBy(objective, i, sharesAround(found_.in(objective)[i]), kEventRounds);
    }
    std::vector<double> point = found_.in(objective);
    settle(objective, point, Tried::inPairs, pool_, evaluations_);
    found_.take(objective, point);
    return refine(plain);
  }

  void crossBy(const Objective& objective, size_t coordinate, const std::vector<double>& shares,
               int rounds) {
    const Crossing crossing =
        crossingOf(objective, found_.in(objective), coordinate, shares, rounds, pool_);
    evaluations_ += crossing.evaluations;
    found_.take(objective, crossing.best);
  }

  // What the recordings do not tell goes back to where it was, if the others can make up for it.
  Status forget() {
    const Objective objective = sharp_.of(seen_);
    const std::vector<double> point = found_.in(objective);
    OBBY_ASSIGN(const Slopes slopes, slopesAt(objective, point, &pool_));
    const Evidence evidence = evidenceOf(slopes);
    std::vector<Parameter> told;
    Found trial{io::RecordBuilder(found_.values.reader()), found_.delay};
    for (size_t i = 0; i < seen_.size(); ++i) {
      if (!hasSlope(seen_[i].kind) || evidence.half[i] < kNothing) {
        told.push_back(seen_[i]);
      } else {
        setValue(trial.values.root().getParams(), seen_[i].name, valueOf(now_, seen_[i].name));
      }
    }
    if (told.size() == seen_.size()) return {};
    const Objective less(sharp_.takes(), told, trial.params(), sharp_.settings());
    OBBY_ASSIGN(const std::vector<double> there,
                refined(less, trial.in(less), kSlopeRounds, evaluations_, &pool_));
    if (less.loss(there) > objective.loss(point) + slackOf(slopes.noise, objective.frames()))
      return {};
    trial.take(less, there);
    found_ = std::move(trial);
    return {};
  }

  const std::vector<Parameter> parameters_;
  const schema::PhysicsParams::Reader now_;
  const FitSettings& settings_;
  ThreadPool& pool_;
  const std::atomic<bool>& stop_;
  const std::function<void(uint32_t, uint32_t, double)>& progress_;
  Objective brief_;              // of no parameters, and so is the next
  Objective sharp_;              // of longer windows
  std::vector<Parameter> seen_;  // those that show
  Found found_;
  uint64_t evaluations_ = 0;
  bool reached_ = false;  // the tolerance
};

}  // namespace

Result<Fit> fit(std::span<const Take> takes, std::vector<Parameter> parameters,
                schema::PhysicsParams::Reader now, const FitSettings& settings, ThreadPool& pool,
                const std::atomic<bool>& stop,
                const std::function<void(uint32_t, uint32_t, double)>& progress) {
  const std::vector<Take> timed = withVelocitiesOfNow(takes);
  return Fitter(timed, std::move(parameters), now, settings, pool, stop, progress).run();
}

}  // namespace obby::calibrate
