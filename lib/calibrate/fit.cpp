#include "calibrate/fit.h"

#include <algorithm>
#include <limits>

#include "calibrate/evidence.h"
#include "calibrate/found.h"
#include "calibrate/instants.h"
#include "calibrate/noise.h"
#include "calibrate/polish.h"
#include "calibrate/search.h"

namespace obby::calibrate {

namespace {

constexpr double kGain = 0.02;      // relative loss reduction that justifies another search
constexpr int kFocusRounds = 4;     // max rounds of focus()
constexpr int kPasses = 6;          // max passes; the restarts belong to the first
constexpr double kOutside = 4;      // standard deviations; larger errors are not noise
constexpr double kFinest = 0.01;    // studs
constexpr uint32_t kMaxRate = 480;  // control steps a second, the limit for levels

// Estimated share of the fit's time that each phase takes.
constexpr Stretch kApproach{0, 0.5}, kFocus{0.5, 0.7}, kQuicken{0.7, 0.85}, kLengthen{0.85, 0.95},
    kWeigh{0.95, 1};

// The first pass takes as long as all others together.
Stretch passOf(int pass) {
  if (pass == 0) return kApproach.of(0, 0.5);
  const double each = 0.5 / (kPasses - 1);
  return kApproach.of(0.5 + each * (pass - 1), 0.5 + each * pass);
}

// The state of one fit.
class Fitter {
 public:
  Fitter(std::span<const Take> takes, std::vector<Parameter> parameters,
         schema::PhysicsParams::Reader now, const FitSettings& settings, Account& account,
         const Work& work)
      : parameters_(std::move(parameters)),
        now_(now),
        settings_(settings),
        account_(account),
        work_(work),
        brief_(takes, {}, now, settings.objective),
        sharp_(brief_.of(std::vector<Parameter>())) {
    found_.values.root().setParams(now);
  }

  Result<Fit> run() {
    Fit out;
    OBBY_RETURN_IF_ERROR(look());
    out.lossBefore = lossNow();
    keep();
    OBBY_RETURN_IF_ERROR(approach());
    OBBY_RETURN_IF_ERROR(focus());
    OBBY_RETURN_IF_ERROR(quicken());
    OBBY_RETURN_IF_ERROR(lengthen());
    OBBY_RETURN_IF_ERROR(fallBack());
    account_.enter("weighing", kWeigh);
    const Objective objective = sharp_.of(seen_);
    OBBY_ASSIGN(Findings findings, findingsOf(objective, found_.in(objective), parameters_, now_,
                                              found_.params(), work_));
    out.parameters = std::move(findings.parameters);
    out.tied = std::move(findings.tied);
    out.evaluations = account_.evaluations();
    out.loss = lossNow();
    out.delay = found_.delay;
    out.controlRate = found_.params().getControlRate();
    out.substeps = found_.params().getSubsteps();
    out.stopped = work_.stopped();
    return out;
  }

 private:
  double lossNow() const {
    const Objective objective = brief_.of(seen_);
    return objective.loss(found_.in(objective));
  }

  // Keeps the best result so far. An interrupted fit returns it.
  void keep() {
    const double now = lossNow();
    if (!(now < nearest_)) return;
    nearest_ = now;
    kept_ = found_.copy();
    account_.found(now);
  }

  // Restores the best result if an interrupted step has made it worse.
  Status fallBack() {
    if (!work_.stopped() || !(nearest_ < lossNow())) return {};
    found_ = std::move(kept_);
    begin();
    return sharpen(settings_.longSeconds);
  }

  Status polish(const Objective& plain, Stretch stretch) {
    return calibrate::polish(plain.of(seen_), found_, work_, stretch);
  }

  // Searches on short windows, each pass from the result of the previous one. A parameter may have
  // an effect only once others are found, and a new value of an event parameter opens new
  // directions. Once the result is within the tolerance, later passes only refine it.
  Status approach() {
    bool reached = false;
    double before = std::numeric_limits<double>::max();
    for (int pass = 0; pass < kPasses && !work_.stopped(); ++pass) {
      const Stretch stretch = passOf(pass);
      if (!reached) {
        search(brief_.of(seen_), found_, pass, settings_, work_, stretch.of(0, 0.5));
        keep();
      }
      OBBY_RETURN_IF_ERROR(polish(brief_, stretch.of(0.5, 1)));
      keep();
      const size_t known = seen_.size();
      OBBY_RETURN_IF_ERROR(look());
      reached = within(found_, brief_.takes(), settings_);
      const double now = lossNow();
      const bool gained = pass == 0 || seen_.size() > known || now < (1 - kGain) * before;
      if (now < kNoLoss || !gained) break;
      before = now;
    }
    return {};
  }

  // Uses the same windows, but gives the most weight to those in which the simulator reproduces the
  // recording. The gradients of other windows mean nothing until the same events happen in them.
  Status focus() {
    for (int round = 0; round < kFocusRounds && !work_.stopped(); ++round) {
      const double before = lossNow();
      OBBY_RETURN_IF_ERROR(sharpen(settings_.objective.windowSeconds));
      OBBY_RETURN_IF_ERROR(polish(
          sharp_, kFocus.of(double(round) / kFocusRounds, double(round + 1) / kFocusRounds)));
      keep();
      if (lossNow() > (1 - kGain) * before) break;
    }
    return {};
  }

  // Some engines run the character's rules in each physics step instead of once a frame. Then a
  // jump begins at a step. Keeps one control step per physics step if that fits better. Skips this
  // phase if noise explains the loss, because it takes as long as all earlier phases.
  Status quicken() {
    const uint32_t substeps = now_.getSubsteps(), rate = now_.getControlRate() * substeps;
    const double before = lossNow(), noise = noiseOf(brief_.takes());
    if (work_.stopped() || substeps <= 1 || rate > kMaxRate ||
        before < std::max(kNoLoss, noise * noise))
      return {};
    Found slower = found_.copy();
    found_.setRate(rate, 1);
    begin();
    // Fails if the level cannot be compiled at this rate, for example if motion tables get too
    // long.
    if (sharpen(settings_.objective.windowSeconds)) {
      OBBY_RETURN_IF_ERROR(polish(sharp_, kQuicken));
      if (lossNow() < (1 - kGain) * before) {
        keep();
        return {};
      }
    }
    found_ = std::move(slower);
    begin();
    return {};
  }

  // Refines on long windows, where the error of a single sample matters less.
  Status lengthen() {
    OBBY_RETURN_IF_ERROR(sharpen(settings_.longSeconds));
    OBBY_RETURN_IF_ERROR(polish(sharp_, kLengthen));
    return forget();
  }

  // Rebuilds the objectives at the current control rate.
  void begin() {
    brief_ = Objective(brief_.takes(), {}, found_.params(), settings_.objective);
    sharp_ = brief_.of(std::vector<Parameter>());
  }

  // Limits the weight of windows that miss an event because of noise in one sample.
  Status sharpen(double windowSeconds) {
    const Objective objective = brief_.of(seen_);
    OBBY_ASSIGN(const double noise, noiseAt(objective, found_.in(objective)));
    ObjectiveSettings settings = settings_.objective;
    settings.windowSeconds = windowSeconds;
    settings.near = std::clamp(kOutside * noise, kFinest, settings.near);
    sharp_ = Objective(brief_.takes(), {}, found_.params(), settings);
    return {};
  }

  // Adds the parameters that have an effect at the point found.
  Status look() {
    const Objective all = brief_.of(parameters_);
    const std::vector<double> point = found_.in(all);
    OBBY_ASSIGN(const std::vector<float> here, all.residuals(point));
    for (size_t i = 0; i < parameters_.size() && !work_.stopped(); ++i) {
      const bool is = std::any_of(seen_.begin(), seen_.end(), [&](const Parameter& s) {
        return s.name == parameters_[i].name;
      });
      if (!is && shows(all, point, i, here)) seen_.push_back(parameters_[i]);
    }
    return {};
  }

  // Resets parameters that the recordings do not determine, if the others can compensate.
  Status forget() {
    const Objective objective = sharp_.of(seen_);
    const std::vector<double> point = found_.in(objective);
    OBBY_ASSIGN(const Derivatives derivatives, derivativesAt(objective, point, work_));
    if (work_.stopped()) return {};
    const Evidence evidence = evidenceOf(derivatives);
    std::vector<Parameter> determined;
    Found trial = found_.copy();
    for (size_t i = 0; i < seen_.size(); ++i) {
      if (!isDifferentiable(seen_[i].kind) || evidence.half[i] < kNothing) {
        determined.push_back(seen_[i]);
      } else {
        setValue(trial.values.root().getParams(), seen_[i].name, valueOf(now_, seen_[i].name));
      }
    }
    if (determined.size() == seen_.size()) return {};
    const Objective less(sharp_.takes(), determined, trial.params(), sharp_.settings());
    OBBY_ASSIGN(const std::vector<double> there,
                refined(less, trial.in(less), kGradientRounds, work_));
    if (less.loss(there) > objective.loss(point) + slackOf(derivatives, objective.frames()))
      return {};
    trial.take(less, there);
    found_ = std::move(trial);
    return {};
  }

  const std::vector<Parameter> parameters_;
  const schema::PhysicsParams::Reader now_;
  const FitSettings& settings_;
  Account& account_;
  const Work& work_;
  Objective brief_;              // on short windows; without parameters
  Objective sharp_;              // as sharpen() last made it; without parameters
  std::vector<Parameter> seen_;  // parameters with an effect
  Found found_, kept_;
  double nearest_ = std::numeric_limits<double>::max();  // loss of kept_
};

}  // namespace

Result<Fit> fit(std::span<const Take> takes, std::vector<Parameter> parameters,
                schema::PhysicsParams::Reader now, const FitSettings& settings, ThreadPool& pool,
                const std::atomic<bool>& stop,
                const std::function<void(const FitProgress&)>& progress) {
  const std::vector<Take> timed = withVelocitiesOfNow(takes, now);
  Account account(progress);
  const Work work(pool, stop, account);
  return Fitter(timed, std::move(parameters), now, settings, account, work).run();
}

}  // namespace obby::calibrate
