#include "import/records/designer_queries.h"

#include <capnp/dynamic.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>

#include "import/document/pose_math.h"
#include "import/records/level_record.h"
#include "import/records/record_values.h"
#include "io/json_codec.h"

namespace obby::importer {
namespace {

constexpr const char* kFolder = "ObbyQueries";
constexpr const char* kPhysics = "physics";
constexpr const char* kForbid = "forbid";
constexpr const char* kStartTick = "startTick";
constexpr double kStartRate = 60;  // a start tick is 1/60 s, whatever the level's rate
constexpr double kMaxStart = 5e8;
constexpr const char* kOwnOfQueries[] = {kForbid, kStartTick};
constexpr std::string_view kKinds[] = {"goal", "start", "avoid", "visit", "waypoint"};
constexpr const char* kOwnOfRegions[] = {"kind", "order", "cframe", "size", "part", "touch"};

// Returns the first Folder of that name. Instances of other classes may have the name, too.
InstanceId folderOf(const Tree& tree) {
  const InstanceId storage = tree.service("ServerStorage");
  const auto& among = storage == kNoInstance ? tree.document().roots : tree.at(storage).children;
  for (const InstanceId id : among) {
    if (tree.at(id).name == kFolder && tree.at(id).className == "Folder") return id;
  }
  return kNoInstance;
}

template <class T>
const T* attribute(const Instance& instance, const char* name) {
  const auto found = instance.attributes.find(name);
  return found == instance.attributes.end() ? nullptr : std::get_if<T>(&found->second);
}

std::string textProperty(const Instance& instance, const char* name) {
  const auto* text = attribute<std::string>(instance, name);
  return text ? validUtf8(*text) : "";
}

double orderOf(const Instance& instance) {
  const auto* order = attribute<double>(instance, "order");
  return order && std::isfinite(*order) ? *order : HUGE_VAL;
}

class Reader {
 public:
  Reader(const LevelDraft& level, const Tree& tree, uint16_t rate,
         std::vector<std::string>& warnings)
      : level_(level), tree_(tree), rate_(rate), warnings_(warnings) {}

  std::optional<io::RecordBuilder> query(InstanceId id) {
    io::RecordBuilder record;
    auto query = record.root().initQuery();
    query.setId(validUtf8(tree_.at(id).name));
    query.setLevel(validUtf8(level_.name));
    fillNumbers(id, query, kOwnOfQueries);
    fillForbidden(id, query);
    fillStartTick(id, query);
    const auto goals = regions(id, "goal");
    if (goals.empty()) {
      warn(id, "has no goal and is left out");
      return {};
    }
    fillRegion(goals[0], query.initGoal());
    fillRegions({goals.begin() + 1, goals.end()}, [&](uint32_t n) { return query.initGoals(n); });
    warnOfKinds(id);
    const auto starts = regions(id, "start");
    if (!starts.empty()) fillRegion(starts[0], query.getStart().initRegion());
    for (size_t i = 1; i < starts.size(); ++i)
      warn(starts[i], "is an extra start and is left out; a query can have only one");
    fillRegions(regions(id, "avoid"), [&](uint32_t n) { return query.initAvoid(n); });
    fillRegions(regions(id, "visit"), [&](uint32_t n) { return query.initVisits(n); });
    fillWaypoints(regions(id, "waypoint"), query);
    return record;
  }

 private:
  void warn(InstanceId id, const std::string& what) {
    warnings_.push_back(level_.file + ": " + tree_.path(id) + " " + what);
  }

  // Warns of regions of an unknown kind: the answer would ignore their condition.
  void warnOfKinds(InstanceId query) {
    for (const InstanceId child : tree_.at(query).children) {
      if (tree_.at(child).className != "Configuration") continue;
      const std::string kind = textProperty(tree_.at(child), "kind");
      if (std::find(std::begin(kKinds), std::end(kKinds), kind) == std::end(kKinds))
        warn(child, fmt::format("has the unknown kind '{}' and is left out; expected one of {}",
                                kind, fmt::join(kKinds, ", ")));
    }
  }

  // Returns the regions of a kind, sorted by their attribute `order`. A region without a place is
  // left out with a warning.
  std::vector<InstanceId> regions(InstanceId query, std::string_view kind) {
    std::vector<InstanceId> out;
    for (const InstanceId child : tree_.at(query).children) {
      const Instance& region = tree_.at(child);
      if (region.className != "Configuration" || textProperty(region, "kind") != kind) continue;
      const auto* size = attribute<Vec3>(region, "size");
      const bool box =
          attribute<CFrame>(region, "cframe") && size && size->x > 0 && size->y > 0 && size->z > 0;
      if (box || !textProperty(region, "part").empty()) {
        out.push_back(child);
      } else {
        warn(child, "names neither a part nor a box (cframe and size) and is left out");
      }
    }
    std::stable_sort(out.begin(), out.end(), [&](InstanceId a, InstanceId b) {
      return orderOf(tree_.at(a)) < orderOf(tree_.at(b));
    });
    return out;
  }

  void fillRegion(InstanceId id, schema::Region::Builder to) {
    const Instance& region = tree_.at(id);
    to.setName(validUtf8(region.name));
    if (const std::string part = textProperty(region, "part"); !part.empty()) {
      to.setPart(part);
      const bool* touch = attribute<bool>(region, "touch");
      to.setTouch(touch && *touch);
      return;
    }
    const CFrame& frame = *attribute<CFrame>(region, "cframe");
    setVector(to.initPosition(), frame.position);
    bool reflected = false;
    setRotation(to.initRotation(), repairedRotation(frame.rotation, &reflected));
    setVector(to.initSize(), *attribute<Vec3>(region, "size"));
  }

  template <class Init>
  void fillRegions(const std::vector<InstanceId>& ids, const Init& init) {
    if (ids.empty()) return;
    auto list = init(uint32_t(ids.size()));
    for (uint32_t i = 0; i < ids.size(); ++i) fillRegion(ids[i], list[i]);
  }

  void fillWaypoints(const std::vector<InstanceId>& ids, schema::Query::Builder query) {
    if (ids.empty()) return;
    auto list = query.initWaypoints(uint32_t(ids.size()));
    for (uint32_t i = 0; i < ids.size(); ++i) {
      fillRegion(ids[i], list[i].initRegion());
      fillNumbers(ids[i], list[i], kOwnOfRegions);
    }
  }

  // Fills the forbidden states from a text with commas or blanks between them.
  void fillForbidden(InstanceId id, schema::Query::Builder query) {
    if (!tree_.at(id).attributes.contains(kForbid)) return;
    if (!attribute<std::string>(tree_.at(id), kForbid)) {
      warn(id, "has an attribute 'forbid' that is not a string");
      return;
    }
    std::vector<schema::PlayerState> states;
    const auto known = capnp::Schema::from<schema::PlayerState>();
    const std::string text = textProperty(tree_.at(id), kForbid);
    for (size_t from = 0; (from = text.find_first_not_of(", ", from)) != std::string::npos;) {
      const std::string name = text.substr(from, text.find_first_of(", ", from) - from);
      from += name.size();
      KJ_IF_MAYBE (state, known.findEnumerantByName(name)) {
        states.push_back(schema::PlayerState(state->getOrdinal()));
      } else {
        warn(id, fmt::format("forbids '{}', which is not a player state", name));
      }
    }
    if (states.empty()) return;
    auto list = query.initForbid(uint32_t(states.size()));
    for (uint32_t i = 0; i < states.size(); ++i) list.set(i, states[i]);
  }

  // Stores the start with the query, since a start at the level's spawn has no region to hold it. A
  // calibration may change the ticks a second, but not the designer's start time.
  void fillStartTick(InstanceId id, schema::Query::Builder query) {
    if (!tree_.at(id).attributes.contains(kStartTick)) return;
    const double* tick = attribute<double>(tree_.at(id), kStartTick);
    if (tick && *tick >= 0 && *tick <= kMaxStart && std::floor(*tick) == *tick) {
      query.initStart().setTick(uint32_t(std::floor(*tick * rate_ / kStartRate + 0.5)));
    } else {
      warn(id, "has an attribute 'startTick' that is not a whole number of 0 or more");
    }
  }

  // Fills number fields of the record from attributes with their names. The values are checked
  // where queries are compiled.
  void fillNumbers(InstanceId id, capnp::DynamicStruct::Builder to,
                   std::span<const char* const> own) {
    for (const auto& [name, value] : tree_.at(id).attributes) {
      if (std::find(own.begin(), own.end(), name) != own.end()) continue;
      const double* number = std::get_if<double>(&value);
      KJ_IF_MAYBE (field, to.getSchema().findFieldByName(name.c_str())) {
        if (number && setNumber(to, *field, *number)) continue;
        warn(id,
             fmt::format("has an attribute '{}' that is not a number or is out of range", name));
      } else {
        warn(id, fmt::format("has an unknown attribute '{}'", name));
      }
    }
  }

  static bool setNumber(capnp::DynamicStruct::Builder to, capnp::StructSchema::Field field,
                        double number) {
    switch (field.getType().which()) {
      case capnp::schema::Type::INT32:
        if (!(std::fabs(number) <= 1e9) || std::floor(number) != number) return false;
        to.set(field, int32_t(number));
        return true;
      case capnp::schema::Type::FLOAT32:
        if (!(std::fabs(number) <= 1e9)) return false;
        to.set(field, number);
        return true;
      default: return false;
    }
  }

  const LevelDraft& level_;
  const Tree& tree_;
  uint16_t rate_;  // ticks a second
  std::vector<std::string>& warnings_;
};

}  // namespace

std::vector<io::RecordBuilder> designerQueries(const LevelDraft& level, const Tree& tree,
                                               uint16_t rate, std::vector<std::string>& warnings) {
  std::vector<io::RecordBuilder> out;
  const InstanceId folder = folderOf(tree);
  if (folder == kNoInstance) return out;
  Reader reader(level, tree, rate, warnings);
  for (const InstanceId child : tree.at(folder).children) {
    if (tree.at(child).className != "Configuration") continue;
    if (auto query = reader.query(child)) out.push_back(std::move(*query));
  }
  return out;
}

std::optional<io::Record> designerPhysics(const Tree& tree, std::vector<std::string>& warnings) {
  const InstanceId folder = folderOf(tree);
  if (folder == kNoInstance) return {};
  const auto* text = attribute<std::string>(tree.at(folder), kPhysics);
  if (!text) return {};
  auto read = io::recordFromJson(*text);
  if (read && read->reader().isParams()) return io::Record(*std::move(read));
  warnings.push_back(tree.document().file + ": " + tree.path(folder) +
                     ": its attribute 'physics' is not a valid params record: " +
                     (read ? "the record has another type" : read.error().text()));
  return {};
}

}  // namespace obby::importer
