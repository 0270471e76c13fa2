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

constexpr double kGain = 0.02;       // share of the loss that makes another worth its time
constexpr int kFocusRounds = 4;      // of focus()
constexpr int kPasses = 6;           // searches at most, the first with its restarts counted once
constexpr double kOutside = 4;       // deviations that noise does not explain
constexpr double kFinest = 0.01;     // studs
constexpr uint32_t kMostRate = 480;  // rules a second: the most that levels admit

// About what share of the time each takes.
constexpr Stretch kApproach{0, 0.5}, kFocus{0.5, 0.7}, kQuicken{0.7, 0.85}, kLengthen{0.85, 0.95},
    kWeigh{0.95, 1};

// The first pass takes as long as all others.
Stretch passOf(int pass) {
  if (pass == 0) return kApproach.of(0, 0.5);
  const double each = 0.5 / (kPasses - 1);
  return kApproach.of(0.5 + each * (pass - 1), 0.5 + each * pass);
}

// Everything that one fit needs, from its beginning to its end.
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

  // Of all that was found on the way, what comes nearest: an interrupted fit ends at it.
  void keep() {
    const double now = lossNow();
    if (!(now < nearest_)) return;
    nearest_ = now;
    kept_ = found_.copy();
    account_.found(now);
  }

  // Steps that a stop ended in their midst may have gone the wrong way.
  Status fallBack() {
    if (!work_.stopped() || !(nearest_ < lossNow())) return {};
    found_ = std::move(kept_);
    begin();
    return sharpen(settings_.longSeconds);
  }

  Status polish(const Objective& plain, Stretch stretch) {
    return calibrate::polish(plain.of(seen_), found_, work_, stretch);
  }

  // By short windows, in searches each of which goes on from the one before: a parameter may show
  // only where others have been found, and another place in a crossing gives a search new ways.
  // Within the tolerance nothing is searched any more, only refined.
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

  // By the same windows, but so that those count most in which the simulator does what was
  // recorded: others pull at slopes that they know nothing of, until what happens in them is right,
  // too.
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

  // Some engines run the character's rules in each step of their physics, not once a frame: then
  // who holds jump leaves at a step. Kept if it comes nearer; not tried where noise explains what
  // is left (it leaves half of its square), since it takes as long as all that came before.
  Status quicken() {
    const uint32_t substeps = now_.getSubsteps(), rate = now_.getControlRate() * substeps;
    const double before = lossNow(), noise = noiseOf(brief_.takes());
    if (work_.stopped() || substeps <= 1 || rate > kMostRate ||
        before < std::max(kNoLoss, noise * noise))
      return {};
    Found slower = found_.copy();
    found_.setRate(rate, 1);
    begin();
    // An error: a level that cannot be played so, as where tables of long motions become too long.
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

  // By windows to which an error of a single sample matters less.
  Status lengthen() {
    OBBY_RETURN_IF_ERROR(sharpen(settings_.longSeconds));
    OBBY_RETURN_IF_ERROR(polish(sharp_, kLengthen));
    return forget();
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
    for (size_t i = 0; i < parameters_.size() && !work_.stopped(); ++i) {
      const bool is = std::any_of(seen_.begin(), seen_.end(), [&](const Parameter& s) {
        return s.name == parameters_[i].name;
      });
      if (!is && shows(all, point, i, here)) seen_.push_back(parameters_[i]);
    }
    return {};
  }

  // What the recordings do not tell goes back to where it was, if the others can make up for it.
  Status forget() {
    const Objective objective = sharp_.of(seen_);
    const std::vector<double> point = found_.in(objective);
    OBBY_ASSIGN(const Slopes slopes, slopesAt(objective, point, work_));
    if (work_.stopped()) return {};
    const Evidence evidence = evidenceOf(slopes);
    std::vector<Parameter> told;
    Found trial = found_.copy();
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
                refined(less, trial.in(less), kSlopeRounds, work_));
    if (less.loss(there) > objective.loss(point) + slackOf(slopes, objective.frames())) return {};
    trial.take(less, there);
    found_ = std::move(trial);
    return {};
  }

  const std::vector<Parameter> parameters_;
  const schema::PhysicsParams::Reader now_;
  const FitSettings& settings_;
  Account& account_;
  const Work& work_;
  Objective brief_;              // of no parameters, and so is the next
  Objective sharp_;              // of longer windows
  std::vector<Parameter> seen_;  // those that show
  Found found_, kept_;
  double nearest_ = std::numeric_limits<double>::max();  // loss of what is kept
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
