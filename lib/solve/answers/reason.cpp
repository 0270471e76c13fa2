#include "solve/answers/reason.h"

#include <fmt/format.h>

#include "sim/candidates.h"
#include "sim/loose_contacts.h"

namespace obby::solve {

namespace {

std::string plural(uint64_t n, const char* word) {
  return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
}

std::string countText(uint64_t n) {
  if (n >= 10'000'000) return fmt::format("{:.0f} million", double(n) * 1e-6);
  if (n >= 1'000'000) return fmt::format("{:.1f} million", double(n) * 1e-6);
  return fmt::format("{}", n);
}

std::string solvedText(const SearchOutcome& outcome, const level::Level& level) {
  const Playthrough& best = outcome.solutions.front();
  std::string text = fmt::format("reached the goal in {:.2f} s with {}",
                                 double(best.ticks) / level.view().params.controlRate,
                                 plural(best.end.jumps, "jump"));
  if (const uint32_t n = targetsReached(best.end)) text += ", past " + plural(n, "waypoint");
  if (outcome.solutions.size() > 1) {
    text += fmt::format("; the shortest of {} {}", outcome.solutions.size(),
                        outcome.diverse ? "routes" : "distinct ways");
  }
  if (outcome.knownSolutions > 0) text += "; an earlier way still works";
  return text;
}

// A region or part of the query's avoid list.
std::string avoidText(schema::Query::Reader query, uint32_t index) {
  if (index >= query.getAvoid().size()) return "entered an avoid region";
  const auto region = query.getAvoid()[index];
  const std::string name = region.getName().size() > 0
                               ? fmt::format(" '{}'", region.getName().cStr())
                               : fmt::format(" {}", index);
  return region.getTouch() ? fmt::format("touched part {}{}", region.getPartIndex(), name)
                           : "entered avoid region" + name;
}

std::string endText(const EndCount& end, const level::Level& level, schema::Query::Reader query) {
  switch (end.outcome) {
    case sim::Outcome::killed:
      return end.part < level.partCount()
                 ? fmt::format("were killed by part {} '{}'", end.part, level.partName(end.part))
                 : "were killed";
    case sim::Outcome::fell: return "fell";
    case sim::Outcome::avoided: return avoidText(query, end.part);
    case sim::Outcome::jumps: return "needed more jumps than allowed";
    case sim::Outcome::timeout: return "ran out of time";
    case sim::Outcome::hurt:
      return "lost more health than allowed" +
             (end.part < level.partCount()
                  ? fmt::format(", at last by part {} '{}'", end.part, level.partName(end.part))
                  : std::string());
    case sim::Outcome::forbidden: return "were in a forbidden state";
    case sim::Outcome::running:
    case sim::Outcome::goal: break;
  }
  return "got no further";
}

// The most frequent ends of those attempts that failed for good.
std::string endsText(const SearchOutcome& outcome, const level::Level& level,
                     schema::Query::Reader query) {
  uint64_t all = 0;
  for (const EndCount& e : outcome.ends) all += e.count;
  std::string text;
  int named = 0;
  for (const EndCount& e : outcome.ends) {
    if (e.outcome == sim::Outcome::running || named == 2) continue;
    text += fmt::format("{}{:.0f} % of the attempts {}", named == 0 ? "; " : ", ",
                        100.0 * double(e.count) / double(all), endText(e, level, query));
    ++named;
  }
  return text;
}

std::string placeText(const SearchOutcome& outcome, schema::Query::Reader query) {
  const Closest& c = outcome.statistics.closest;
  if (c.distance >= 1e29f) return "no attempt got anywhere";
  std::string to = "goal";
  if (outcome.targetCount > c.targets) {
    const bool ordered = query.getVisits().size() == 0;
    to = ordered ? fmt::format("waypoint {}", c.targets + 1) : std::string("next waypoint");
  }
  std::string text = fmt::format("the closest came within {:.1f} studs of the {}", c.distance, to);
  if (c.targets > 0) text += ", past " + plural(c.targets, "waypoint");
  return text;
}

// Is there hope in searching on?
std::string hopeText(const Thoroughness& t) {
  const float more = 100 * newCellsIfTwice(t);
  if (!saturated(t)) return "; new places were still being found: more time may help";
  return more < 0.1f ? std::string("; searching on would find nothing new at this resolution")
                     : fmt::format("; as long again would find about {:.1f} % new places", more);
}

// What the simulator had to leave out.
std::string overrunText(uint8_t overruns) {
  std::string text;
  if (overruns & sim::kCandidateOverrun) {
    text +=
        fmt::format("; some attempts met more than {} parts at once ({} moving), the rest ignored",
                    sim::kMaxCandidates, sim::kMaxMovingCandidates);
  }
  if (overruns & sim::kClockOverrun) {
    text += fmt::format(
        "; some attempts had more than {} touched parts at work at once, the rest did nothing",
        sim::kMaxClocks);
  }
  if (overruns & sim::kContactOverrun) {
    text += fmt::format(
        "; in some attempts loose bodies had more than {} contacts at once, the rest ignored",
        sim::kMaxLooseContacts);
  }
  return text;
}

// What the place has and the level has not: the way may need it.
std::string unmodelledText(schema::Level::Reader level) {
  std::string kinds;
  for (const auto& u : level.getUnmodelled()) {
    kinds += fmt::format("{}{} ({})", kinds.empty() ? "" : ", ", u.getKind().cStr(), u.getCount());
  }
  return kinds.empty() ? kinds : "; the place has what is not simulated: " + kinds;
}

}  // namespace

std::string reasonFor(const SearchOutcome& outcome, const level::Level& level,
                      schema::Level::Reader levelRecord, schema::Query::Reader query) {
  if (outcome.cut) return reasonFor(*outcome.cut, level);
  const std::string overruns = overrunText(outcome.statistics.overruns);
  if (!outcome.solutions.empty()) return solvedText(outcome, level) + overruns;
  std::string text =
      fmt::format("no way found in {} steps{}: ", countText(outcome.statistics.steps),
                  outcome.stopped == Stopped::interrupted ? " (interrupted)" : "");
  text += placeText(outcome, query) + endsText(outcome, level, query);
  text += hopeText(outcome.thoroughness);
  return text + overruns + unmodelledText(levelRecord) + "; this does not show that there is none";
}

}  // namespace obby::solve
