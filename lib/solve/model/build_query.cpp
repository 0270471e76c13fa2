#include "solve/model/build_query.h"

#include <capnp/schema.h>
#include <fmt/format.h>

#include <span>

#include "base/listed.h"
#include "level/resolve_places.h"
#include "level/select_parts.h"
#include "level/tricks.h"

namespace obby::solve {

namespace {

constexpr std::string_view kTouch = "touch:";

// Returns the error with the option of the bad selector as its path.
Error inOption(Error error, const char* option) {
  error.path = option;
  return error;
}

// Maps fields of the query to the options that set them.
struct FieldOption {
  const char *field, *option;
};
constexpr FieldOption kQueryOptions[] = {{"start", "--start"},
                                         {"goal", "--goal"},
                                         {"waypoints", "--waypoint"},
                                         {"visits", "--visit"},
                                         {"avoid", "--avoid"}};
constexpr FieldOption kPassOptions[] = {{"visits", "--pass"}, {"avoid", "--not-pass"}};

const char* optionOf(const std::string& path, std::span<const FieldOption> options) {
  for (const auto& [field, option] : options) {
    if (path.starts_with(field)) return option;
  }
  return "";
}

Status fillPlace(schema::Region::Builder record, std::string selector, const char* option) {
  if (selector.starts_with(kTouch)) {
    record.setTouch(true);
    selector.erase(0, kTouch.size());
  }
  const auto box = level::boxFromText(selector);
  if (!box) return inOption(box.error(), option);
  if (!*box) {
    record.setPart(selector);
    return {};
  }
  if (record.getTouch()) {
    return inOption(
        makeError(fmt::format("'{}' is a box, but only a part can be touched", selector)), option);
  }
  record.setName((*box)->name);
  level::fillBox(record, **box);
  return {};
}

template <class List>
Status fillPlaces(List list, const std::vector<std::string>& selectors, const char* option) {
  for (uint32_t i = 0; i < list.size(); ++i) {
    OBBY_RETURN_IF_ERROR(fillPlace(list[i], selectors[i], option));
  }
  return {};
}

// Fills in the start. A part with a spawn on it stands for that spawn.
Status fillStart(schema::Level::Reader level, const std::string& selector,
                 schema::Query::Builder query) {
  const uint32_t tick = query.getStart().getTick();
  auto start = query.initStart();
  start.setTick(tick);
  if (const auto part = level::matchPart(level, selector)) {
    for (uint32_t i = 0; i < level.getSpawns().size(); ++i) {
      if (level.getSpawns()[i].getPart() != int32_t(*part)) continue;
      start.setSpawn(int32_t(i));
      return {};
    }
  }
  return fillPlace(start.initRegion(), selector, "--start");
}

// Returns the part where the level ends: a goal of stage 0, or any goal, or the last checkpoint; -1
// if there is none.
int64_t lastPart(schema::Level::Reader level) {
  int64_t goal = -1, checkpoint = -1;
  bool final = false;
  int32_t stage = 0;
  uint32_t i = 0;
  for (const auto part : level.getParts()) {
    if (part.hasGoal() && (goal < 0 || (!final && part.getGoal().getStage() == 0))) {
      goal = i;
      final = part.getGoal().getStage() == 0;
    }
    if (part.hasCheckpoint() && part.getCheckpoint().getStage() > stage) {
      checkpoint = i;
      stage = part.getCheckpoint().getStage();
    }
    ++i;
  }
  return goal >= 0 ? goal : checkpoint;
}

Status fillDefaults(schema::Level::Reader level, schema::Query::Builder query) {
  if (!query.hasStart() && level.getSpawns().size() == 0) {
    return makeError(fmt::format("level '{}' has no spawn", level.getName().cStr()),
                     "give --start PLACE");
  }
  if (query.hasGoal()) return {};
  const int64_t part = lastPart(level);
  if (part < 0) {
    return makeError(fmt::format("level '{}' has no query, no goal part and no checkpoint",
                                 level.getName().cStr()),
                     "give --goal PLACE, or put a query record after the level");
  }
  query.initGoal().setPart(fmt::format("part:{}", part));
  return {};
}

Status fillStates(const std::vector<std::string>& names, schema::Query::Builder query) {
  auto forbid = query.initForbid(uint32_t(names.size()));
  const auto known = capnp::Schema::from<schema::PlayerState>();
  for (uint32_t i = 0; i < forbid.size(); ++i) {
    const auto state = known.findEnumerantByName(names[i]);
    KJ_IF_MAYBE (found, state) {
      forbid.set(i, schema::PlayerState(found->getOrdinal()));
    } else {
      return inOption(makeError(fmt::format("unknown state '{}'", names[i]),
                                "give jumping, climbing, seated or fallingDown"),
                      "--forbid");
    }
  }
  return {};
}

// Sets an enum field to the value of a name.
template <class Enum>
Status fillChoice(const std::string& name, const char* option, Enum& value) {
  const auto names = capnp::Schema::from<Enum>();
  KJ_IF_MAYBE (found, names.findEnumerantByName(name)) {
    value = Enum(found->getOrdinal());
    return {};
  }
  std::vector<std::string> known;
  for (const auto row : names.getEnumerants()) known.emplace_back(row.getProto().getName());
  return inOption(makeError(fmt::format("unknown value '{}'", name), "give " + listed(known, "or")),
                  option);
}

Status fillArrive(const std::string& name, schema::Query::Builder query) {
  schema::Arrive arrive{};
  OBBY_RETURN_IF_ERROR(fillChoice(name, "--arrive", arrive));
  query.setArrive(arrive);
  return {};
}

Status fillDirections(const std::string& name, schema::Query::Builder query) {
  schema::Directions directions{};
  OBBY_RETURN_IF_ERROR(fillChoice(name, "--directions", directions));
  query.setDirections(directions);
  return {};
}

Status fillTricks(const std::vector<std::string>& names, schema::Query::Builder query) {
  auto bits = level::tricksNamed(names);
  if (!bits) return inOption(std::move(bits).error(), "--tricks");
  query.disownTricks();
  level::setTricks(query, *bits);
  return {};
}

// Returns the first option that is set.
const char* firstOption(const QuickQuery& q) {
  const std::pair<bool, const char*> options[] = {
      {!q.start.empty(), "--start"},          {!q.goals.empty(), "--goal"},
      {!q.waypoints.empty(), "--waypoint"},   {!q.visits.empty(), "--visit"},
      {!q.avoid.empty(), "--avoid"},          {!q.forbid.empty(), "--forbid"},
      {!q.arrive.empty(), "--arrive"},        {q.minJumps >= 0, "--min-jumps"},
      {q.maxJumps >= 0, "--max-jumps"},       {q.timeLimit > 0, "--max-time"},
      {q.maxDamage >= 0, "--max-damage"},     {!q.tricks.empty(), "--tricks"},
      {!q.directions.empty(), "--directions"}};
  for (const auto& [given, option] : options) {
    if (given) return option;
  }
  return "";
}

// Replaces the fields of the query that `quick` sets.
Status fill(schema::Level::Reader level, const QuickQuery& quick, schema::Query::Builder query) {
  // A title names the start and the goal, so the old one no longer fits.
  if (!quick.start.empty() || !quick.goals.empty()) query.disownTitle();
  if (!quick.start.empty()) OBBY_RETURN_IF_ERROR(fillStart(level, quick.start, query));
  if (!quick.goals.empty()) {
    const std::vector<std::string> others(quick.goals.begin() + 1, quick.goals.end());
    OBBY_RETURN_IF_ERROR(fillPlace(query.initGoal(), quick.goals.front(), "--goal"));
    OBBY_RETURN_IF_ERROR(fillPlaces(query.initGoals(uint32_t(others.size())), others, "--goal"));
  }
  if (!quick.waypoints.empty()) {
    auto waypoints = query.initWaypoints(uint32_t(quick.waypoints.size()));
    for (uint32_t i = 0; i < waypoints.size(); ++i) {
      OBBY_RETURN_IF_ERROR(fillPlace(waypoints[i].initRegion(), quick.waypoints[i], "--waypoint"));
    }
  }
  if (!quick.visits.empty()) {
    OBBY_RETURN_IF_ERROR(
        fillPlaces(query.initVisits(uint32_t(quick.visits.size())), quick.visits, "--visit"));
  }
  if (!quick.avoid.empty()) {
    OBBY_RETURN_IF_ERROR(
        fillPlaces(query.initAvoid(uint32_t(quick.avoid.size())), quick.avoid, "--avoid"));
  }
  if (!quick.forbid.empty()) OBBY_RETURN_IF_ERROR(fillStates(quick.forbid, query));
  if (!quick.arrive.empty()) OBBY_RETURN_IF_ERROR(fillArrive(quick.arrive, query));
  if (!quick.directions.empty()) OBBY_RETURN_IF_ERROR(fillDirections(quick.directions, query));
  if (!quick.tricks.empty()) OBBY_RETURN_IF_ERROR(fillTricks(quick.tricks, query));
  if (quick.minJumps >= 0) query.setMinJumps(quick.minJumps);
  if (quick.maxJumps >= 0) query.setMaxJumps(quick.maxJumps);
  if (quick.timeLimit > 0) query.setTimeLimit(quick.timeLimit);
  if (quick.maxDamage >= 0) query.setMaxDamage(quick.maxDamage);
  return {};
}

Result<io::Record> resolved(schema::Level::Reader level, io::RecordBuilder record,
                            std::span<const FieldOption> options) {
  if (Status status = level::resolvePlaces(level, record.root().getQuery()); !status) {
    const char* option = optionOf(status.error().path, options);
    return inOption(std::move(status).error(), option);
  }
  return io::Record(std::move(record));
}

}  // namespace

bool hasEnd(schema::Level::Reader level) { return lastPart(level) >= 0; }

Error lacksGoal(schema::Level::Reader level, const QuickQuery& quick, uint64_t queries) {
  std::string hint = "give --goal PLACE";
  if (queries == 1) hint += ", or --each to apply the option to the level's own query";
  if (queries > 1)
    hint += fmt::format(", or --each to apply the option to the level's own {} queries", queries);
  return inOption(
      makeError(
          fmt::format(
              "this option starts a new query, but level '{}' has no goal part and no checkpoint",
              level.getName().cStr()),
          std::move(hint)),
      firstOption(quick));
}

Result<io::Record> buildQuery(schema::Level::Reader level, const QuickQuery& quick,
                              const std::string& id) {
  io::RecordBuilder record;
  auto query = record.root().initQuery();
  query.setId(id);
  query.setLevel(level.getName());
  OBBY_RETURN_IF_ERROR(fill(level, quick, query));
  OBBY_RETURN_IF_ERROR(fillDefaults(level, query));
  return resolved(level, std::move(record), kQueryOptions);
}

Result<io::Record> buildPlaces(schema::Level::Reader level, const std::vector<std::string>& pass,
                               const std::vector<std::string>& notPass) {
  io::RecordBuilder record;
  auto query = record.root().initQuery();
  OBBY_RETURN_IF_ERROR(fillPlaces(query.initVisits(uint32_t(pass.size())), pass, "--pass"));
  OBBY_RETURN_IF_ERROR(
      fillPlaces(query.initAvoid(uint32_t(notPass.size())), notPass, "--not-pass"));
  return resolved(level, std::move(record), kPassOptions);
}

Result<io::Record> changeQuery(schema::Level::Reader level, const QuickQuery& quick,
                               const io::Record& query) {
  io::RecordBuilder record(query.reader());
  OBBY_RETURN_IF_ERROR(fill(level, quick, record.root().getQuery()));
  return resolved(level, std::move(record), kQueryOptions);
}

}  // namespace obby::solve
