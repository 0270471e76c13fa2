// Writes a level into the page's data: parts as columns, names, hulls and motion.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "view/page_parts.h"
#include "view/roles.h"
#include "view/tracks.h"

namespace obby::view {
namespace {

void push(std::vector<float>& out, schema::Vec3::Reader v) {
  out.insert(out.end(), {v.getX(), v.getY(), v.getZ()});
}

// Writes the distinct material names, the first of which is empty, and each part's index into them.
void writeMaterials(io::JsonWriter& json, schema::Level::Reader level) {
  constexpr size_t kMax = 256;  // limit of a byte column; further materials look like plastic
  std::vector<std::string_view> names = {""};
  std::map<std::string_view, uint8_t> places = {{"", 0}};
  std::vector<uint8_t> column;
  for (const auto part : level.getParts()) {
    const std::string_view name = part.getMaterial().cStr();
    auto place = places.find(name);
    if (place == places.end() && names.size() < kMax) {
      place = places.emplace(name, uint8_t(names.size())).first;
      names.push_back(name);
    }
    column.push_back(place == places.end() ? 0 : place->second);
  }
  json.key("material").packed(column).key("materials").list(names);
}

// Returns the simulated shape: a hull without pieces is a block.
schema::Shape shapeOf(schema::Part::Reader part) {
  const bool unknown = part.getShape() == schema::Shape::HULL && part.getHulls().size() == 0;
  return unknown ? schema::Shape::BLOCK : part.getShape();
}

// Returns true for each part that the simulator contains and never moves.
std::vector<bool> stillParts(const level::LevelView& view, size_t parts) {
  std::vector<bool> still(parts, false);
  for (uint32_t i = 0; i < view.colliderCount; ++i) {
    const level::Collider& c = view.colliders[i];
    if (c.mover == level::kNone && c.body == level::kNoBody) still[c.part] = true;
  }
  return still;
}

void writeColumns(io::JsonWriter& json, schema::Level::Reader level, const level::LevelView& view) {
  const std::vector<bool> still = stillParts(view, level.getParts().size());
  std::vector<float> position, rotation, size;
  std::vector<uint8_t> shape, look, flags;
  for (uint32_t i = 0; i < level.getParts().size(); ++i) {
    const auto part = level.getParts()[i];
    // Keys with a single pose move nothing, but they override the part's own pose.
    const auto keys = part.getMotion().getKeys();
    const bool placed = still[i] && keys.size() > 0;
    push(position, placed ? keys[keys.size() - 1].getPosition() : part.getPosition());
    push(size, part.getSize());
    const auto q = placed ? keys[keys.size() - 1].getRotation() : part.getRotation();
    rotation.insert(rotation.end(), {q.getX(), q.getY(), q.getZ(), q.getW()});
    shape.push_back(uint8_t(shapeOf(part)));
    const auto color = part.getColor();
    const float alpha = std::clamp(1 - part.getTransparency(), 0.0f, 1.0f);
    look.insert(look.end(),
                {color.getR(), color.getG(), color.getB(), uint8_t(std::lround(alpha * 255))});
    flags.push_back(uint8_t((part.getSolid() ? 1 : 0) | (part.getTouch() ? 2 : 0)));
  }
  json.key("parts").open('{').field("count", level.getParts().size());
  json.key("position").packed(position).key("rotation").packed(rotation).key("size").packed(size);
  json.key("shape").packed(shape).key("role").packed(rolesOf(level));
  json.key("look").packed(look).key("flags").packed(flags);
  writeMaterials(json, level);
  json.close();
}

void writeNames(io::JsonWriter& json, schema::Level::Reader level) {
  json.key("names").open('[');
  for (const auto part : level.getParts()) {
    const auto path = part.getSource().getPath();
    json.value(std::string_view(path.size() != 0 ? path.cStr() : part.getName().cStr()));
  }
  json.close().key("notes").open('{');
  for (uint32_t i = 0; i < level.getParts().size(); ++i) {
    const auto evidence = level.getParts()[i].getEvidence();
    if (evidence.size() == 0) continue;
    json.key(std::to_string(i)).open('[');
    for (const auto item : evidence) {
      json.value(std::string(item.getRole()) + ": " + std::string(item.getReason()) +
                 (item.getGuessed() ? " (guessed)" : ""));
    }
    json.close();
  }
  json.close();
}

void writeTags(io::JsonWriter& json, schema::Level::Reader level) {
  json.key("tags").open('{');
  for (uint32_t i = 0; i < level.getParts().size(); ++i) {
    const auto tags = level.getParts()[i].getTags();
    if (tags.size() == 0) continue;
    json.key(std::to_string(i)).open('[');
    for (const auto tag : tags) json.value(std::string_view(tag.cStr()));
    json.close();
  }
  json.close();
}

void writeHulls(io::JsonWriter& json, schema::Level::Reader level) {
  json.key("hulls").open('[');
  for (uint32_t i = 0; i < level.getParts().size(); ++i) {
    const auto part = level.getParts()[i];
    if (shapeOf(part) != schema::Shape::HULL) continue;
    json.open('{').field("part", i).key("pieces").open('[');
    for (const auto hull : part.getHulls()) {
      std::vector<float> vertices;
      for (const auto v : hull.getVertices()) push(vertices, v);
      json.packed(vertices);
    }
    json.close().close();
  }
  json.close();
}

// Returns the timer of each part that the level clock makes appear and disappear, else null.
std::vector<const level::Roles*> timersOf(const level::LevelView& level, size_t parts) {
  std::vector<const level::Roles*> timers(parts, nullptr);
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if ((level.bounds[i].flags & level::kVanishTimer) == 0) continue;
    timers[level.colliders[i].part] = &level.roles[level.colliders[i].role];
  }
  return timers;
}

void writeVanishing(io::JsonWriter& json, schema::Level::Reader level,
                    const level::LevelView& view) {
  const auto timers = timersOf(view, level.getParts().size());
  json.key("vanish").open('[');
  for (uint32_t i = 0; i < level.getParts().size(); ++i) {
    const auto part = level.getParts()[i];
    if (!part.hasVanish() && !part.hasFall()) continue;
    const level::Roles* const timer = timers[i];
    json.open('{').field("part", i).field("trigger", timer != nullptr ? "timer" : "touch");
    if (part.getVanish().getInverted()) json.field("inverted", 1);
    if (timer != nullptr) {
      json.field("delay", timer->vanishDelay).field("away", timer->vanishAway);
      json.field("phase", timer->vanishPhase);
    }
    json.close();
  }
  json.close();
}

void writeConveyors(io::JsonWriter& json, schema::Level::Reader level) {
  json.key("conveyors").open('[');
  for (uint32_t i = 0; i < level.getParts().size(); ++i) {
    const auto part = level.getParts()[i];
    if (!part.hasConveyor()) continue;
    const auto v = part.getConveyor().getVelocity();
    json.open('{').field("part", i).key("velocity").open('[');
    json.value(v.getX()).value(v.getY()).value(v.getZ()).close().close();
  }
  json.close();
}

void writeTrack(io::JsonWriter& json, const Track& track) {
  if (track.positions.empty() && track.rotations.empty()) return;
  json.open('{').field("part", track.part).field("stride", track.stride);
  json.field("count", track.count).field("loopFrom", track.loopFrom);
  if (track.triggered) json.field("triggered", 1);
  if (!track.positions.empty()) json.key("position").packed(track.positions);
  if (!track.rotations.empty()) json.key("rotation").packed(track.rotations);
  json.close();
}

// Writes the parts that a trajectory may move.
void writeBodies(io::JsonWriter& json, const level::LevelView& level) {
  json.key("bodies").open('[');
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    json.value(level.colliders[level.bodies[i].firstCollider].part);
  }
  json.close();
}

}  // namespace

void writeLevel(io::JsonWriter& json, const LevelEntry& entry, uint32_t ticksShown,
                uint32_t trackStride) {
  const auto level = entry.reader();
  const auto physics = level.getPhysics();
  json.open('{').field("name", std::string_view(level.getName().cStr()));
  json.field("file", std::string_view(level.getSource().getFile().cStr()));
  json.field("tickRate", physics.getControlRate())
      .field("fallHeight", physics.getFallenPartsHeight());
  json.key("body").open('{').field("width", physics.getBodyWidth());
  json.field("depth", physics.getBodyDepth()).field("hip", physics.getHipHeight());
  json.field("neck", physics.getHeadBottom()).field("top", physics.getBodyTop());
  json.field("span", physics.getArmSpan()).close();
  writeColumns(json, level, entry.level->view());
  writeNames(json, level);
  writeTags(json, level);
  writeHulls(json, level);
  writeVanishing(json, level, entry.level->view());
  writeConveyors(json, level);
  json.key("tracks").open('[');
  forTracks(entry.level->view(), ticksShown, trackStride,
            [&](const Track& track) { writeTrack(json, track); });
  json.close();
  writeBodies(json, entry.level->view());
  json.close();
}

}  // namespace obby::view
