#include "level/resolve_places.h"

#include <fmt/format.h>

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

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

Status resolve(PartIndex& index, schema::Region::Builder region, const std::string& path,
               bool start = false) {
  if (region.getPart().size() == 0) return {};
  const auto part = matchPart(index, region.getPart().cStr());
  if (!part) return inField(part.error(), path);
  const auto record = index.level().getParts()[*part];
  fill(region, start ? regionOnTop(record) : regionAround(record), *part);
  return {};
}

// Makes every part with the goal's tag a goal: the first one here, the others among the further
// goals.
Status spreadGoal(PartIndex& index, schema::Query::Builder query) {
  const std::string selector = query.getGoal().getPart().cStr();
  if (!selector.starts_with("#")) return {};
  const auto parts = matchParts(index, selector);
  if (!parts) return inField(parts.error(), "goal");
  if (parts->size() == 1) return {};
  const auto old = query.disownGoals();
  const uint32_t before = old.getReader().size(), others = uint32_t(parts->size() - 1);
  auto goals = query.initGoals(before + others);
  for (uint32_t i = 0; i < before; ++i) goals.setWithCaveats(i, old.getReader()[i]);
  for (uint32_t i = 0; i < others; ++i) {
    goals.setWithCaveats(before + i, query.getGoal().asReader());
    goals[before + i].setPart(fmt::format("part:{}", (*parts)[i + 1]));
  }
  query.getGoal().setPart(fmt::format("part:{}", parts->front()));
  return {};
}

// Parts that a selector in a list may stand for.
enum class Fits {
  one,  // all parts with a tag, or the only part with a name
  all,  // all parts that fit
};

// One entry of a list after its parts were found.
struct Entry {
  uint32_t from;  // index in the original list
  int64_t part;   // -1 for a box
  bool shared;    // true if its selector fits other parts, too
};

// Finds the parts of a query's lists. Each selector is looked up once, however often it is listed.
class ListedParts {
 public:
  explicit ListedParts(PartIndex& index) : index_(index) {}

  Result<std::vector<Entry>> entriesOf(capnp::List<schema::Region>::Reader list, const char* name,
                                       Fits fits) {
    std::vector<Entry> entries;
    for (uint32_t i = 0; i < list.size(); ++i) {
      if (list[i].getPart().size() == 0) {
        entries.push_back({i, -1, false});
        continue;
      }
      const std::string selector = list[i].getPart().cStr();
      const auto parts = partsOf(selector, fits);
      if (!parts) return inField(parts.error(), fmt::format("{}[{}]", name, i));
      places_ += (*parts)->size();
      if (places_ > kMaxPlaces) {
        return pathError(fmt::format("{}[{}].part", name, i),
                         fmt::format("with '{}', the query lists more than {} parts and boxes",
                                     selector, kMaxPlaces),
                         "name each part once, or use one box around many parts");
      }
      for (const uint32_t part : **parts) entries.push_back({i, part, (*parts)->size() > 1});
    }
    return entries;
  }

 private:
  Result<const std::vector<uint32_t>*> partsOf(const std::string& selector, Fits fits) {
    auto known = known_.find(selector);
    if (known == known_.end()) {
      OBBY_ASSIGN(std::vector<uint32_t> parts, matchParts(index_, selector));
      known = known_.emplace(selector, std::move(parts)).first;
    }
    const bool mayBeMany = fits == Fits::all || selector.starts_with("#");
    if (known->second.size() > 1 && !mayBeMany) return matchPart(index_, selector).error();
    return &known->second;
  }

  PartIndex& index_;
  std::unordered_map<std::string, std::vector<uint32_t>> known_;
  size_t places_ = 0;  // entries that stand for parts, in all lists
};

// `disown` removes a list from the query, and `init` makes a new one in its place.
template <class Disown, class Init>
Status resolveList(schema::Level::Reader level, ListedParts& listed, const char* name, Fits fits,
                   Disown&& disown, Init&& init) {
  const auto old = disown();
  const auto list = old.getReader();
  if (list.size() == 0) return {};
  OBBY_ASSIGN(const std::vector<Entry> entries, listed.entriesOf(list, name, fits));
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
  PartIndex index(level);
  if (query.hasStart() && query.getStart().hasRegion()) {
    OBBY_RETURN_IF_ERROR(resolve(index, query.getStart().getRegion(), "start.region", true));
  }
  if (query.hasGoal()) {
    OBBY_RETURN_IF_ERROR(spreadGoal(index, query));
    OBBY_RETURN_IF_ERROR(resolve(index, query.getGoal(), "goal"));
  }
  if (query.hasWaypoints()) {
    auto waypoints = query.getWaypoints();
    for (uint32_t i = 0; i < waypoints.size(); ++i) {
      if (!waypoints[i].hasRegion()) continue;
      OBBY_RETURN_IF_ERROR(
          resolve(index, waypoints[i].getRegion(), fmt::format("waypoints[{}].region", i)));
    }
  }
  ListedParts listed(index);
  OBBY_RETURN_IF_ERROR(resolveList(
      level, listed, "avoid", Fits::all, [&] { return query.disownAvoid(); },
      [&](uint32_t n) { return query.initAvoid(n); }));
  OBBY_RETURN_IF_ERROR(resolveList(
      level, listed, "goals", Fits::one, [&] { return query.disownGoals(); },
      [&](uint32_t n) { return query.initGoals(n); }));
  return resolveList(
      level, listed, "visits", Fits::one, [&] { return query.disownVisits(); },
      [&](uint32_t n) { return query.initVisits(n); });
}

}  // namespace obby::level
