// Relaxes the limits of a query: allows more jumps, time or damage, or removes the limit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solve/report/relaxation/relaxations.h"

namespace obby::solve {

namespace {

// A kind of limit.
struct Measure {
  schema::RelaxationKind kind;
  double notch;
  double none;                                    // the value that means no limit
  double (*used)(const Trajectory&, float rate);  // total use by a trajectory
  const char* within;                             // the preposition before the limit
  std::string (*text)(double limit);
};

double jumpsUsed(const Trajectory& p, float) { return p.end.jumps; }
double secondsUsed(const Trajectory& p, float rate) { return p.ticks / double(rate); }
double healthUsed(const Trajectory& p, float) { return double(p.end.damage); }

std::string jumpsText(double n) { return fmt::format("{:.0f} jump{}", n, n == 1 ? "" : "s"); }
std::string secondsText(double s) { return fmt::format("{:.4g} s", s); }
std::string healthText(double h) { return fmt::format("{:.4g} health lost", h); }

constexpr Measure kJumps{schema::RelaxationKind::JUMPS, 1, -1, jumpsUsed, "with", jumpsText};
constexpr Measure kSeconds{schema::RelaxationKind::TIME, 0.1, 0, secondsUsed, "in", secondsText};
constexpr Measure kHealth{schema::RelaxationKind::DAMAGE, 1, -1, healthUsed, "with", healthText};

// One limit that a query has.
struct Limit {
  const Measure& measure;
  std::string field;
  double value;
  std::string where;  // text like " up to waypoint 2"; empty: in total
  std::function<void(schema::Query::Builder, double)> set;
};

Change changeOf(const Limit& limit, float rate) {
  const Measure& m = limit.measure;
  const double now = limit.value;
  Change c;
  c.kind = m.kind;
  c.field = limit.field;
  c.notch = m.notch;
  c.scale = std::max(now, m.notch);
  c.first = {kOff};
  const auto turned = [&m, now](uint32_t n) { return n == kOff ? m.none : now + n * m.notch; };
  c.apply = [set = limit.set, turned](schema::Level::Builder, schema::Query::Builder query,
                                      uint32_t n) { set(query, turned(n)); };
  // For the limit of a segment this may be more than needed, but never less.
  c.enough = [&m, now, rate](const Trajectory& p) {
    return uint32_t(std::max(std::ceil((m.used(p, rate) - now) / m.notch - 1e-4), 1.0));
  };
  c.text = [&m, now, turned, where = limit.where](uint32_t n) {
    if (n == kOff) return fmt::format("solvable without the limit of {}{}", m.text(now), where);
    return fmt::format("solvable {} {}{} instead of {:.4g}", m.within, m.text(turned(n)), where,
                       now);
  };
  return c;
}

class Limits {
 public:
  explicit Limits(schema::Query::Reader query) {
    addTotals(query);
    for (uint32_t i = 0; i < query.getWaypoints().size(); ++i) {
      addWaypoint(i, query.getWaypoints()[i]);
    }
  }
  const std::vector<Limit>& all() const { return all_; }

 private:
  // Times of 0 and counts below 0 mean no limit.
  template <class Set>
  void add(const Measure& m, std::string field, double value, std::string where, Set set) {
    if (m.none == 0 ? value > 0 : value >= 0) {
      all_.push_back({m, std::move(field), value, std::move(where), set});
    }
  }

  void addTotals(schema::Query::Reader q) {
    using Query = schema::Query::Builder;
    const std::string last =
        q.getWaypoints().size() > 0 ? " from the last waypoint to the goal" : "";
    add(kJumps, "maxJumps", q.getMaxJumps(), "",
        [](Query b, double v) { b.setMaxJumps(int32_t(v)); });
    add(kJumps, "segmentJumps", q.getSegmentJumps(), last,
        [](Query b, double v) { b.setSegmentJumps(int32_t(v)); });
    add(kSeconds, "timeLimit", double(q.getTimeLimit()), "",
        [](Query b, double v) { b.setTimeLimit(float(v)); });
    add(kSeconds, "segmentTime", double(q.getSegmentTime()), last,
        [](Query b, double v) { b.setSegmentTime(float(v)); });
    add(kHealth, "maxDamage", double(q.getMaxDamage()), "",
        [](Query b, double v) { b.setMaxDamage(float(v)); });
  }

  void addWaypoint(uint32_t i, schema::Waypoint::Reader w) {
    const std::string field = fmt::format("waypoints[{}].", i);
    const std::string upTo = fmt::format(" up to waypoint {}", i + 1);
    const std::string segment =
        i == 0 ? upTo : fmt::format(" from waypoint {} to waypoint {}", i, i + 1);
    using Query = schema::Query::Builder;
    add(kJumps, field + "maxJumps", w.getMaxJumps(), upTo,
        [i](Query b, double v) { b.getWaypoints()[i].setMaxJumps(int32_t(v)); });
    add(kJumps, field + "segmentJumps", w.getSegmentJumps(), segment,
        [i](Query b, double v) { b.getWaypoints()[i].setSegmentJumps(int32_t(v)); });
    add(kSeconds, field + "timeLimit", double(w.getTimeLimit()), upTo,
        [i](Query b, double v) { b.getWaypoints()[i].setTimeLimit(float(v)); });
    add(kSeconds, field + "segmentTime", double(w.getSegmentTime()), segment,
        [i](Query b, double v) { b.getWaypoints()[i].setSegmentTime(float(v)); });
  }

  std::vector<Limit> all_;
};

}  // namespace

std::vector<Change> limitChanges(const Failure& failure) {
  const float rate = failure.posed.level.view().params.controlRate;
  std::vector<Change> changes;
  const Limits limits(failure.posed.queryRecord);
  for (const Limit& limit : limits.all()) changes.push_back(changeOf(limit, rate));
  return changes;
}

}  // namespace obby::solve
