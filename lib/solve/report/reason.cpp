#include "solve/report/reason.h"

#include <fmt/format.h>

#include "base/listed.h"
#include "io/text.h"
#include "level/tricks.h"
#include "sim/body_contacts.h"
#include "sim/candidates.h"
#include "solve/report/part_text.h"

namespace obby::solve {

namespace {

// The level and query that the sentences are about.
struct Asked {
  const level::Level& level;
  schema::Level::Reader levelRecord;
  schema::Query::Reader query;
};

// Returns the time in the game that corresponds to a number of simulated ticks.
std::string playText(uint64_t ticks, float rate) {
  const double seconds = double(ticks) / double(rate);
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * 3600) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.0f} days", seconds / 86400);
}

std::string solvedText(const SearchOutcome& outcome, const level::Level& level) {
  const Trajectory& best = outcome.solutions.front();
  std::string text = fmt::format("Reached the goal in {:.2f} s with {}",
                                 double(best.ticks) / level.view().params.controlRate,
                                 io::plural(best.end.jumps, "jump"));
  if (const uint32_t n = targetsReached(best.end)) text += ", via " + io::plural(n, "waypoint");
  text += ".";
  if (outcome.solutions.size() > 1) {
    text += fmt::format(" This is the best of {} {}.", outcome.solutions.size(),
                        outcome.diverse ? "routes" : "distinct solutions");
  }
  if (outcome.knownSolutions > 0) text += " An earlier solution still works.";
  return text;
}

// Describes how an attempt violated an entry of the query's avoid list.
std::string avoidText(const Asked& asked, uint32_t index) {
  if (index >= asked.query.getAvoid().size()) return "entered an avoid region";
  const auto region = asked.query.getAvoid()[index];
  if (region.getTouch() && region.getPartIndex() >= 0) {
    return "touched " + partText(asked.levelRecord, uint32_t(region.getPartIndex()));
  }
  return region.getName().size() > 0
             ? fmt::format("entered avoid region '{}'", region.getName().cStr())
             : fmt::format("entered avoid region {}", index + 1);
}

std::string endText(const EndCount& end, const Asked& asked) {
  const bool byPart = end.part < asked.level.partCount();
  const auto part = [&] { return partText(asked.levelRecord, end.part); };
  switch (end.outcome) {
    case sim::Outcome::killed: return byPart ? "were killed by " + part() : "were killed";
    case sim::Outcome::fell: return "fell";
    case sim::Outcome::avoided: return avoidText(asked, end.part);
    case sim::Outcome::jumps: return "needed more jumps than allowed";
    case sim::Outcome::timeout: return "ran out of time";
    case sim::Outcome::hurt:
      return std::string("lost more health than allowed") +
             (byPart ? ", the last of it to " + part() : std::string());
    case sim::Outcome::forbidden: return "entered a forbidden state";
    case sim::Outcome::running:
    case sim::Outcome::goal: break;
  }
  return "got no further";
}

// Names the two most frequent ends of failed attempts.
std::string endsText(const SearchOutcome& outcome, const Asked& asked) {
  uint64_t all = 0;
  for (const EndCount& e : outcome.ends) all += e.count;
  std::string text;
  int named = 0;
  for (const EndCount& e : outcome.ends) {
    if (e.outcome == sim::Outcome::running || named == 2) continue;
    text += fmt::format("{}{:.0f} % {}{}", named == 0 ? " " : ", and ",
                        100.0 * double(e.count) / double(all), named == 0 ? "of attempts " : "",
                        endText(e, asked));
    ++named;
  }
  return named > 0 ? text + "." : text;
}

std::string placeText(const SearchOutcome& outcome, const Asked& asked) {
  const Closest& c = outcome.statistics.closest;
  if (c.distance >= 1e29f) return " No attempt got anywhere.";
  std::string to = "the goal";
  if (outcome.targetCount > c.targets) {
    const bool ordered = asked.query.getVisits().size() == 0;
    to = ordered ? fmt::format("waypoint {}", c.targets + 1) : std::string("the next waypoint");
  }
  std::string text =
      fmt::format(" The closest attempt came within {:.1f} studs of {}", c.distance, to);
  if (c.targets > 0) text += ", after passing " + io::plural(c.targets, "waypoint");
  return text + ".";
}

// Tells if a longer search is likely to help.
std::string hopeText(const Coverage& t) {
  const float more = 100 * newCellsIfTwice(t);
  if (!saturated(t)) return " The search was still finding new places, so more time may help.";
  if (more < 0.1f) {
    return " Searching twice as long would find almost no new places.";
  }
  return fmt::format(" Searching twice as long would find only about {:.{}f} % more places.", more,
                     more < 1 ? 1 : 0);
}

// Tells which limits of the simulator were exceeded.
std::string overrunText(uint8_t overruns) {
  std::string text;
  if (overruns & sim::kCandidateOverrun) {
    text += fmt::format(
        " Some attempts met more than {} parts, or {} moving parts, at once; the simulator ignored "
        "the rest.",
        sim::kMaxCandidates, sim::kMaxMovingCandidates);
  }
  if (overruns & sim::kClockOverrun) {
    text += fmt::format(
        " In some attempts, more than {} touched parts were active at once; the rest did not "
        "react.",
        sim::kMaxClocks);
  }
  if (overruns & sim::kContactOverrun) {
    text += fmt::format(
        " In some attempts, dynamic parts had more than {} contacts at once; the simulator ignored "
        "the rest.",
        sim::kMaxBodyContacts);
  }
  return text;
}

// Lists the kinds of things that the level lacks and a solution may need.
std::string unmodelledText(schema::Level::Reader level) {
  std::string kinds;
  for (const auto& u : level.getUnmodelled()) {
    if (u.getBearing() == schema::Bearing::HARDER) continue;
    kinds += fmt::format("{}{} ({})", kinds.empty() ? "" : ", ", u.getKind().cStr(), u.getCount());
  }
  return kinds.empty() ? kinds : " Not simulated in this place: " + kinds + ".";
}

std::string stepText(const Cut& cut, const level::Level& level, schema::Level::Reader record) {
  const auto nameOf = [&](uint32_t collider) {
    return partText(record, level.view().colliders[collider].part);
  };
  const Missing& m = cut.missing;
  const std::string from = m.from == level::kNone ? "the start" : nameOf(m.from);
  std::string lacks;
  if (m.rise > 0) lacks = fmt::format("{:.1f} studs too high", m.rise);
  if (m.gap > 0) lacks += fmt::format("{}{:.1f} studs too far", m.rise > 0 ? " and " : "", m.gap);
  if (lacks.empty()) return {};
  return fmt::format(" From {}, {} is {}{}{}.", from,
                     m.to == level::kNone ? cut.target : nameOf(m.to), m.blocked ? "at least " : "",
                     lacks, m.more ? ", and later steps are out of reach, too" : "");
}

// Returns "none is", "only 1 is" or "only 2 are".
std::string allowedText(uint32_t n) {
  if (n == 0) return "none is";
  return fmt::format("only {} {}", n, n == 1 ? "is" : "are");
}

// Tells for which tricks the cut holds.
std::string tricksText(const Cut& cut) {
  if (cut.withTricks) return " No trick changes this.";
  if (cut.mayHelp == 0) return " This assumes normal play; several tricks together might help.";
  std::vector<std::string> names;
  for (const auto trick : level::tricksIn(cut.mayHelp)) names.push_back(level::trickName(trick));
  return fmt::format(" This assumes normal play; a trick ({}) might help.", listed(names, "or"));
}

std::string cutText(const Cut& cut, const level::Level& level, schema::Level::Reader record) {
  if (cut.jumps > 0) {
    return fmt::format("Every route to {} takes at least {} jump{}, but {} allowed.", cut.target,
                       cut.jumps, cut.jumps == 1 ? "" : "s", allowedText(cut.maxJumps));
  }
  if (cut.seconds > 0) {
    return fmt::format("Every route to {} takes at least {:.2f} s, but only {:.2f} s is allowed.",
                       cut.target, cut.seconds, cut.maxSeconds);
  }
  return fmt::format("No player can reach {}{}.{} At most {} part{} reachable.", cut.target,
                     cut.mayJump ? "" : " without jumping", stepText(cut, level, record),
                     cut.reached.size(), cut.reached.size() == 1 ? " is" : "s are");
}

}  // namespace

std::string reasonFor(const SearchOutcome& outcome, const level::Level& level,
                      schema::Level::Reader levelRecord, schema::Query::Reader query) {
  if (outcome.cut) return cutText(*outcome.cut, level, levelRecord) + tricksText(*outcome.cut);
  const Asked asked{level, levelRecord, query};
  const std::string overruns = overrunText(outcome.statistics.overruns);
  if (!outcome.solutions.empty()) return solvedText(outcome, level) + overruns;
  const float rate = level.view().params.controlRate;
  std::string text = fmt::format("No solution found in {} of simulated play{}.",
                                 playText(outcome.statistics.steps, rate),
                                 outcome.stopped == Stopped::interrupted ? " (interrupted)" : "");
  text += placeText(outcome, asked) + endsText(outcome, asked) + hopeText(outcome.coverage);
  return text + overruns + unmodelledText(levelRecord) +
         " This does not prove that no solution exists.";
}

}  // namespace obby::solve
