// Relaxations that remove an obstacle: a part that kills, an avoid region, a forbidden state.
#include <fmt/format.h>

#include "solve/report/part_text.h"
#include "solve/report/relaxation/relaxations.h"

namespace obby::solve {

namespace {

constexpr size_t kMaxEach = 4;  // changes of each kind, for the most frequent ends of attempts

Change without(schema::RelaxationKind kind, const std::string& text) {
  Change c;
  c.kind = kind;
  c.first = {kOff};
  c.text = [text](uint32_t) { return text; };
  return c;
}

Change withoutKill(schema::Level::Reader level, uint32_t part) {
  Change c = without(schema::RelaxationKind::KILL_PART,
                     fmt::format("solvable if {} were harmless", partText(level, part)));
  c.part = int32_t(part);
  c.apply = [part](schema::Level::Builder record, schema::Query::Builder, uint32_t) {
    record.getParts()[part].disownKill();
  };
  return c;
}

std::string withoutAvoidText(const PosedQuery& posed, uint32_t index) {
  const auto region = posed.queryRecord.getAvoid()[index];
  if (region.getTouch() && region.getPartIndex() >= 0) {
    return fmt::format("solvable if touching {} were allowed",
                       partText(posed.levelRecord, uint32_t(region.getPartIndex())));
  }
  const bool named = region.getName().size() > 0;
  return fmt::format(
      "solvable if entering avoid region {} were allowed",
      named ? fmt::format("'{}'", region.getName().cStr()) : fmt::format("{}", index + 1));
}

Change withoutAvoid(const PosedQuery& posed, uint32_t index) {
  Change c = without(schema::RelaxationKind::AVOID, withoutAvoidText(posed, index));
  c.avoid = int32_t(index);
  c.field = fmt::format("avoid[{}]", index);
  c.apply = [index](schema::Level::Builder, schema::Query::Builder record, uint32_t) {
    const auto old = record.disownAvoid();
    const auto all = old.getReader();
    auto rest = record.initAvoid(all.size() - 1);
    for (uint32_t i = 0; i < rest.size(); ++i) {
      rest.setWithCaveats(i, all[i < index ? i : i + 1]);
    }
  };
  return c;
}

const char* wordFor(schema::PlayerState state) {
  switch (state) {
    case schema::PlayerState::JUMPING: return "jumping";
    case schema::PlayerState::CLIMBING: return "climbing";
    case schema::PlayerState::SEATED: return "sitting";
    case schema::PlayerState::FALLING_DOWN: return "falling down";
    default: return "that state";
  }
}

Change withoutForbidden(schema::PlayerState state, uint32_t index) {
  Change c = without(schema::RelaxationKind::FORBIDDEN,
                     fmt::format("solvable if {} were allowed", wordFor(state)));
  c.field = fmt::format("forbid[{}]", index);
  c.apply = [index](schema::Level::Builder, schema::Query::Builder record, uint32_t) {
    const auto old = record.disownForbid();
    const auto all = old.getReader();
    auto rest = record.initForbid(all.size() - 1);
    for (uint32_t i = 0; i < rest.size(); ++i) rest.set(i, all[i < index ? i : i + 1]);
  };
  return c;
}

}  // namespace

std::vector<Change> killPartChanges(const Failure& failure) {
  const auto parts = failure.posed.levelRecord.getParts();
  std::vector<Change> changes;
  for (const EndCount& end : failure.outcome.ends) {
    const bool hurts = end.outcome == sim::Outcome::killed || end.outcome == sim::Outcome::hurt;
    if (!hurts || end.part >= parts.size() || !parts[end.part].hasKill()) continue;
    if (changes.size() < kMaxEach)
      changes.push_back(withoutKill(failure.posed.levelRecord, end.part));
  }
  return changes;
}

std::vector<Change> avoidChanges(const Failure& failure) {
  const auto query = failure.posed.queryRecord;
  std::vector<Change> changes;
  for (const EndCount& end : failure.outcome.ends) {
    if (end.outcome != sim::Outcome::avoided || end.part >= query.getAvoid().size()) continue;
    if (changes.size() < kMaxEach) changes.push_back(withoutAvoid(failure.posed, end.part));
  }
  return changes;
}

std::vector<Change> forbiddenChanges(const Failure& failure) {
  const auto states = failure.posed.queryRecord.getForbid();
  std::vector<Change> changes;
  for (uint32_t i = 0; i < states.size(); ++i) changes.push_back(withoutForbidden(states[i], i));
  return changes;
}

}  // namespace obby::solve
