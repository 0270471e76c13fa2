// Host functions for the positions of parts, overlaps and rays.
#include "engine/collision_matrix.h"
#include "engine/host.h"
#include "engine/values/values.h"

namespace obby::engine {
namespace scenery_functions {
namespace {

uint32_t idAt(lua_State* L, int index) { return uint32_t(luaL_checknumber(L, index)); }

int pushIds(lua_State* L, const std::vector<uint32_t>& ids) {
  lua_createtable(L, int(ids.size()), 0);
  for (size_t i = 0; i < ids.size(); ++i) {
    lua_pushnumber(L, lua_Number(ids[i]));
    lua_rawseti(L, -2, int(i + 1));
  }
  return 1;
}

// Returns the geometry's shape for a Part of that class and its Shape.
int shapeOf(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  geom::ShapeKind kind = geom::ShapeKind::block;
  if (name == "WedgePart")
    kind = geom::ShapeKind::wedge;
  else if (name == "CornerWedgePart")
    kind = geom::ShapeKind::cornerWedge;
  else if (name == "Part" && lua_istable(L, 2)) {
    static constexpr geom::ShapeKind kShapes[] = {geom::ShapeKind::ball, geom::ShapeKind::block,
                                                  geom::ShapeKind::cylinder, geom::ShapeKind::wedge,
                                                  geom::ShapeKind::cornerWedge};
    lua_pushliteral(L, "Value");
    lua_rawget(L, 2);
    const size_t item = size_t(lua_tonumber(L, -1));
    if (item < std::size(kShapes)) kind = kShapes[item];
  }
  lua_pushnumber(L, lua_Number(kind));
  return 1;
}

// (id, pose, size, shape, collides, limb): adds a part to the geometry.
int partEnters(lua_State* L) {
  Host& host = Host::of(L);
  Scenery::Part part;
  part.pose = checkCFrame(L, 2);
  part.half = checkVector3(L, 3) * 0.5f;
  part.shape = geom::ShapeKind(luaL_checkint(L, 4));
  part.collides = lua_toboolean(L, 5) != 0;
  part.limb = lua_toboolean(L, 6) != 0;
  const InstanceId id = idAt(L, 1);
  host.scenery.add(id, part);
  if (!part.limb) host.recorder.change({0, id, "Parent", true, host.where(L)});
  return 0;
}

int partLeaves(lua_State* L) {
  Host& host = Host::of(L);
  const InstanceId id = idAt(L, 1);
  const Scenery::Part* const part = host.scenery.find(id);
  if (!part) return 0;
  if (!part->limb) host.recorder.change({0, id, "Parent", false, host.where(L)});
  host.scenery.remove(id);
  return 0;
}

int overlapsOfPart(lua_State* L) {
  return pushIds(L, Host::of(L).scenery.overlapsOfPart(idAt(L, 1)));
}

int overlapsOfBox(lua_State* L) {
  return pushIds(L, Host::of(L).scenery.overlaps(checkCFrame(L, 1), checkVector3(L, 2) * 0.5f));
}

int distanceToPart(lua_State* L) {
  lua_pushnumber(L, lua_Number(Host::of(L).scenery.distance(idAt(L, 1), checkVector3(L, 2))));
  return 1;
}

int castRay(lua_State* L) {
  const auto hits = Host::of(L).scenery.castRay(checkVector3(L, 1), checkVector3(L, 2));
  lua_createtable(L, int(hits.size()), 0);
  for (size_t i = 0; i < hits.size(); ++i) {
    lua_createtable(L, 0, 3);
    lua_pushnumber(L, lua_Number(hits[i].id));
    lua_setfield(L, -2, "id");
    lua_pushnumber(L, lua_Number(hits[i].share));
    lua_setfield(L, -2, "share");
    push(L, hits[i].normal);
    lua_setfield(L, -2, "normal");
    lua_rawseti(L, -2, int(i + 1));
  }
  return 1;
}

// Returns true if a box meets a part that collides. A little slack excludes the floor below it.
int isBlocked(lua_State* L) {
  constexpr float kSlack = 0.05f;
  Scenery& scenery = Host::of(L).scenery;
  const Vec3 half = max(checkVector3(L, 2) * 0.5f - Vec3{kSlack, kSlack, kSlack}, Vec3{});
  bool blocked = false;
  for (const uint32_t id : scenery.overlaps(checkCFrame(L, 1), half)) {
    const Scenery::Part* const part = scenery.find(id);
    blocked = blocked || (part->collides && !part->limb);
  }
  lua_pushboolean(L, blocked);
  return 1;
}

int contactsOf(lua_State* L) {
  std::vector<uint32_t> ids;
  if (!Host::of(L).scenery.contacts(idAt(L, 1), ids)) return 0;
  return pushIds(L, ids);
}

int settleContacts(lua_State* L) {
  Host::of(L).scenery.settle();
  return 0;
}

int listened(lua_State* L) {
  Scenery& scenery = Host::of(L).scenery;
  const uint32_t id = idAt(L, 1);
  if (Scenery::Part* const part = scenery.find(id)) {
    part->listened = true;
    scenery.moved(id);
  }
  return 0;
}

// Returns the collision groups that the place saves, as rows of name, id and mask. Returns no rows
// if the data is damaged.
int savedGroups(lua_State* L) {
  lua_newtable(L);
  for (const Instance& instance : Host::of(L).document.instances) {
    const std::string_view bytes = groupBytes(instance);
    if (bytes.empty()) continue;
    const auto matrix = decodeGroups(bytes);
    if (!matrix) continue;
    for (const auto& [name, id] : matrix->ids) {
      lua_createtable(L, 0, 3);
      lua_pushlstring(L, name.data(), name.size());
      lua_setfield(L, -2, "name");
      lua_pushnumber(L, id);
      lua_setfield(L, -2, "id");
      lua_pushnumber(L, matrix->masks[id]);
      lua_setfield(L, -2, "mask");
      lua_rawseti(L, -2, int(lua_objlen(L, -2)) + 1);
    }
  }
  return 1;
}

constexpr luaL_Reg kFunctions[] = {{"shapeOf", shapeOf},
                                   {"savedGroups", savedGroups},
                                   {"partEnters", partEnters},
                                   {"partLeaves", partLeaves},
                                   {"overlapsOfPart", overlapsOfPart},
                                   {"overlapsOfBox", overlapsOfBox},
                                   {"distanceToPart", distanceToPart},
                                   {"castRay", castRay},
                                   {"isBlocked", isBlocked},
                                   {"contactsOf", contactsOf},
                                   {"settleContacts", settleContacts},
                                   {"listened", listened},
                                   {nullptr, nullptr}};

}  // namespace
}  // namespace scenery_functions

void registerSceneryFunctions(lua_State* L) {
  luaL_register(L, nullptr, scenery_functions::kFunctions);
}

}  // namespace obby::engine
