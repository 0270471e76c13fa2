#include "calibrate/findings.h"

#include <algorithm>
#include <cmath>

#include "calibrate/crossing.h"
#include "calibrate/evidence.h"
#include "calibrate/ticks.h"

namespace obby::calibrate {

namespace {

// An interval is useful if its half width is within this share of the value, or of the upper bound
// if the value may be 0.
constexpr double kKnown = 0.1;
constexpr int kRefiningRounds = 3;  // rounds that refine the other parameters at each value of an
                                    // event parameter
constexpr double kTied = 0.95;      // min absolute correlation

// A parameter is known if its interval is narrow enough: as above, or within one tick.
Fitted judged(Fitted f) {
  const double half = std::max(f.high - f.value, f.value - f.low);
  const double size = f.parameter.lowest > 0 ? f.value : f.parameter.highest;
  f.known = f.tick > 0 ? f.high - f.low < 1.5 * f.tick : half <= kKnown * size;
  return f;
}

Fitted byGradient(Fitted f, double share, double half) {
  if (half >= kNothing) return f;
  f.low = valueAt(f.parameter, share - half);
  f.high = valueAt(f.parameter, share + half);
  return judged(f);
}

// `between`: distance between the tried shares, or 0. Values that close to a possible one may be
// possible, too.
Fitted byProfile(Fitted f, const Profile& profile, double slack, double between) {
  const Possible possible = possibleOf(profile, slack);
  if (possible.all) return f;
  f.low = std::min(f.value, valueAt(f.parameter, possible.min - between));
  f.high = std::max(f.value, valueAt(f.parameter, possible.max + between));
  return judged(f);
}

// Like byProfile(), but rounds to whole ticks.
Fitted byCount(Fitted f, const Profile& profile, double slack, double tick) {
  if (possibleOf(profile, slack).all) return f;
  f.tick = tick;
  f = byProfile(f, profile, slack, 0);
  for (double* time : {&f.value, &f.low, &f.high}) *time = tick * std::round(*time / tick);
  return f;
}

// An objective at a point, with the methods that derive intervals from it.
struct Weighing {
  const Objective& objective;
  const std::vector<double>& point;
  const Work& work;
  const Derivatives& derivatives;

  void byCrossing(size_t coordinate, Fitted& f) const {
    const Crossing crossing =
        crossingOf(objective, point, coordinate, sharesAllOver(), kRefiningRounds, work);
    if (work.stopped()) return;
    const auto& shares = crossing.profile.shares;
    f = byProfile(f, crossing.profile, slackOf(derivatives, objective.frames()),
                  shares[1] - shares[0]);
  }

  void byScan(const std::vector<Fitted*>& fitted) const {
    const Scan scan = scanOf(objective, point, Tried::inPairs, work);
    if (work.stopped()) return;
    for (const Profile& p : scan.profiles) {
      Fitted& f = *fitted[p.coordinate];
      f = byCount(f, p, slackOf(derivatives, scan.frames), 1 / objective.controlRate());
    }
  }
};

// Returns the entries of the objective's parameters, in the objective's order.
std::vector<Fitted*> shownOf(const Objective& objective, std::vector<Fitted>& all) {
  std::vector<Fitted*> out;
  for (const Parameter& p : objective.parameters())
    out.push_back(&*std::find_if(all.begin(), all.end(),
                                 [&](const Fitted& f) { return f.parameter.name == p.name; }));
  return out;
}

}  // namespace

Result<Findings> findingsOf(const Objective& objective, const std::vector<double>& point,
                            const std::vector<Parameter>& asked,
                            schema::PhysicsParams::Reader before,
                            schema::PhysicsParams::Reader found, const Work& work) {
  Findings out;
  for (const Parameter& p : asked)
    out.parameters.push_back(
        {p, valueOf(found, p.name), p.lowest, p.highest, false, valueOf(before, p.name)});
  const std::vector<Fitted*> shown = shownOf(objective, out.parameters);
  OBBY_ASSIGN(const Derivatives derivatives, derivativesAt(objective, point, work.toItsEnd()));
  const Evidence evidence = evidenceOf(derivatives);
  const Weighing weighing{objective, point, work, derivatives};
  for (size_t i = 0; i < shown.size(); ++i) {
    const Parameter::Kind kind = shown[i]->parameter.kind;
    if (isDifferentiable(kind)) *shown[i] = byGradient(*shown[i], point[i], evidence.half[i]);
    if (kind == Parameter::Kind::event && !work.stopped()) weighing.byCrossing(i, *shown[i]);
    work.account().step(i + 1, shown.size() + 1);
    for (size_t k = 0; k < i; ++k) {
      const double c = evidence.correlation(Eigen::Index(i), Eigen::Index(k));
      if (std::fabs(c) > kTied)
        out.tied.push_back({shown[k]->parameter.name, shown[i]->parameter.name, c});
    }
  }
  if (!work.stopped()) weighing.byScan(shown);
  return out;
}

}  // namespace obby::calibrate
