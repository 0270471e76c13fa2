#include "level/resolve_places.h"

#include <fmt/format.h>

#include "level/record_values.h"
#include "level/select_parts.h"

namespace obby::level {

namespace {

Error inField(Error error, const std::string& path) {
  error.path = path + ".part";
  return error;
}

void fill(schema::Region::Builder record, const PlainRegion& box, uint32_t part) {
  if (record.getName().size() == 0) record.setName(box.name);
  fillBox(record, box);
  record.setPartIndex(int32_t(part));
}

Status resolve(schema::Level::Reader level, schema::Region::Builder region, const std::string& path,
               bool start = false) {
  if (region.getPart().size() == 0) return {};
  const auto part = matchPart(level, region.getPart().cStr());
  if (!part) return inField(part.error(), path);
  const auto record = level.getParts()[*part];
  fill(region, start ? regionOnTop(record) : regionAround(record), *part);
  return {};
}

// One entry of a list after its parts have been found.
struct Entry {
  uint32_t from;  // entry of the list as it was
  int64_t part;   // -1: a box
  bool shared;    // its selector fits other parts, too
};

Result<std::vector<Entry>> entriesOf(schema::Level::Reader level,
                                     capnp::List<schema::Region>::Reader list, const char* name) {
  std::vector<Entry> entries;
  for (uint32_t i = 0; i < list.size(); ++i) {
    if (list[i].getPart().size() == 0) {
      entries.push_back({i, -1, false});
      continue;
    }
    const std::string selector = list[i].getPart().cStr();
    const std::string path = fmt::format("{}[{}]", name, i);
    if (!selector.starts_with("#")) {
      const auto part = matchPart(level, selector);
      if (!part) return inField(part.error(), path);
      entries.push_back({i, *part, false});
      continue;
    }
    const auto parts = matchParts(level, selector);
    if (!parts) return inField(parts.error(), path);
    for (const uint32_t part : *parts) entries.push_back({i, part, parts->size() > 1});
  }
  return entries;
}

// `disown` and `init` take a list out of the query, and make a new one in its place.
template <class Disown, class Init>
Status resolveList(schema::Level::Reader level, const char* name, Disown&& disown, Init&& init) {
  const auto old = disown();
  const auto list = old.getReader();
  if (list.size() == 0) return {};
  OBBY_ASSIGN(const std::vector<Entry> entries, entriesOf(level, list, name));
  auto out = init(uint32_t(entries.size()));
  for (uint32_t i = 0; i < out.size(); ++i) {
    const Entry& e = entries[i];
    out.setWithCaveats(i, list[e.from]);
    if (e.part < 0) continue;
    if (e.shared) out[i].setPart(fmt::format("part:{}", e.part));
    fill(out[i], regionAround(level.getParts()[uint32_t(e.part)]), uint32_t(e.part));
  }
  return {};
}

}  // namespace

bool namesParts(schema::Query::Reader query) {
  const auto names = [](schema::Region::Reader region) { return region.getPart().size() > 0; };
  if (names(query.getStart().getRegion()) || names(query.getGoal())) return true;
  for (const auto list : {query.getGoals(), query.getVisits(), query.getAvoid()}) {
    for (const auto region : list) {
      if (names(region)) return true;
    }
  }
  for (const auto waypoint : query.getWaypoints()) {
    if (names(waypoint.getRegion())) return true;
  }
  return false;
}

Status resolvePlaces(schema::Level::Reader level, schema::Query::Builder query) {
  if (query.hasStart() && query.getStart().hasRegion()) {
    OBBY_RETURN_IF_ERROR(resolve(level, query.getStart().getRegion(), "start.region", true));
  }
  if (query.hasGoal()) OBBY_RETURN_IF_ERROR(resolve(level, query.getGoal(), "goal"));
  if (query.hasWaypoints()) {
    auto waypoints = query.getWaypoints();
    for (uint32_t i = 0; i < waypoints.size(); ++i) {
      if (!waypoints[i].hasRegion()) continue;
      OBBY_RETURN_IF_ERROR(
          resolve(level, waypoints[i].getRegion(), fmt::format("waypoints[{}].region", i)));
    }
  }
  OBBY_RETURN_IF_ERROR(resolveList(
      level, "avoid", [&] { return query.disownAvoid(); },
      [&](uint32_t n) { return query.initAvoid(n); }));
  OBBY_RETURN_IF_ERROR(resolveList(
      level, "goals", [&] { return query.disownGoals(); },
      [&](uint32_t n) { return query.initGoals(n); }));
  return resolveList(
      level, "visits", [&] { return query.disownVisits(); },
      [&](uint32_t n) { return query.initVisits(n); });
}

}  // namespace obby::level
