// Host functions that record what happens.
#include <algorithm>
#include <cmath>

#include "engine/host.h"
#include "engine/values/values.h"

namespace obby::engine {

namespace {

// Returns an enum's item as its number.
Plain itemAt(lua_State* L, int index) {
  Plain item;
  for (const char* const key : {"EnumType", "Value"}) {
    lua_pushstring(L, key);
    lua_rawget(L, index);
    const bool isNil = lua_isnil(L, -1);
    if (!isNil && lua_isnumber(L, -1)) item = double(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (isNil) return {};
  }
  return item;
}

}  // namespace

Plain plainAt(lua_State* L, int index) {
  if (const Vec3* const vector = toVector3(L, index)) return *vector;
  if (const Pose* const pose = toCFrame(L, index)) return *pose;
  switch (lua_type(L, index)) {
    case LUA_TBOOLEAN: return lua_toboolean(L, index) != 0;
    case LUA_TNUMBER: return lua_tonumber(L, index);
    case LUA_TSTRING: return std::string(lua_tostring(L, index));
    case LUA_TTABLE: return itemAt(L, index);
    default: return std::monostate{};
  }
}

namespace record_functions {
namespace {

InstanceId idAt(lua_State* L, int index) { return InstanceId(luaL_checknumber(L, index)); }

// Keeps the geometry in line with a part's property.
void follow(Host& host, InstanceId id, const std::string& key, lua_State* L, int index) {
  Scenery::Part* const part = host.scenery.find(id);
  if (!part) return;
  if (key == "CFrame")
    part->pose = checkCFrame(L, index);
  else if (key == "Size")
    part->half = checkVector3(L, index) * 0.5f;
  else if (key == "CanCollide")
    part->collides = lua_toboolean(L, index) != 0;
  else
    return;
  host.scenery.moved(id);
}

// (id, key, value, ofPlayer, isPart): records that a property has changed, unless ofPlayer is
// "silent".
int watched(lua_State* L) {
  Host& host = Host::of(L);
  const InstanceId id = idAt(L, 1);
  const std::string key = luaL_checkstring(L, 2);
  const Scenery::Part* const part = host.scenery.find(id);
  const Pose before = part ? part->pose : Pose{};
  follow(host, id, key, L, 3);
  if (!host.recorder.isRecording() || lua_isstring(L, 4)) return 0;
  const bool ofPlayer = lua_toboolean(L, 4) != 0;
  if (key == "CFrame" && !ofPlayer && lua_toboolean(L, 5) != 0) {
    if (!toCFrame(L, 3)) return 0;
    const bool first = host.recorder.isUnmoved(id);
    host.recorder.place(id, before, checkCFrame(L, 3), first ? host.where(L) : Line{});
    return 0;
  }
  const Line line = host.where(L);
  if (ofPlayer && line.script == kNoInstance) return 0;
  host.recorder.change({0, ofPlayer ? kPlayer : id, key, plainAt(L, 3), line});
  return 0;
}

// (part, driver): records that a constraint or mover moves the part from now on.
int driven(lua_State* L) {
  Host::of(L).recorder.drive(idAt(L, 1), idAt(L, 2));
  return 0;
}

// (tween, target, info, goals, starts): records that the tween begins to play.
int tween(lua_State* L) {
  Host& host = Host::of(L);
  Tween seen;
  seen.time = host.recorder.time();
  seen.id = uint32_t(luaL_checknumber(L, 1));
  seen.target = idAt(L, 2);
  const auto number = [L](const char* key) {
    lua_getfield(L, 3, key);
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
  };
  const auto item = [L](const char* key) {
    lua_getfield(L, 3, key);
    lua_getfield(L, -1, "Value");
    const auto value = integerOf<uint32_t>(lua_tonumber(L, -1));
    lua_pop(L, 2);
    return value;
  };
  seen.seconds = number("Time");
  seen.delay = number("DelayTime");
  seen.repeats = integerOf<int>(number("RepeatCount"));
  seen.style = item("EasingStyle");
  seen.direction = item("EasingDirection");
  lua_getfield(L, 3, "Reverses");
  seen.reverses = lua_toboolean(L, -1) != 0;
  for (lua_pushnil(L); lua_next(L, 4) != 0; lua_pop(L, 1)) {
    lua_getfield(L, 5, lua_tostring(L, -2));
    const int top = lua_gettop(L);
    seen.changes.push_back({lua_tostring(L, -3), plainAt(L, top), plainAt(L, top - 1)});
    lua_pop(L, 1);
  }
  std::sort(seen.changes.begin(), seen.changes.end(),
            [](const TweenChange& a, const TweenChange& b) { return a.property < b.property; });
  seen.line = host.where(L);
  host.recorder.tween(std::move(seen));
  return 0;
}

// (humanoid, before, after, ofPlayer, stoppable): records a change of health.
int health(lua_State* L) {
  Host& host = Host::of(L);
  const double from = luaL_checknumber(L, 2), to = luaL_checknumber(L, 3);
  if (lua_toboolean(L, 4) != 0 && host.recorder.isRecording() && from != to)
    host.recorder.harm(from, to, host.where(L), lua_toboolean(L, 5) != 0);
  return 0;
}

// (id, what, value): records any other event that a probe asks about.
int note(lua_State* L) {
  Host& host = Host::of(L);
  host.recorder.change(
      {0, idAt(L, 1), std::string("note ") + luaL_checkstring(L, 2), plainAt(L, 3), host.where(L)});
  return 0;
}

// (what, id): records that a script listens to an engine event, or reads a value that players
// change.
int heeded(lua_State* L) {
  Host& host = Host::of(L);
  host.recorder.heed(luaL_checkstring(L, 1), idAt(L, 2), host.where(L));
  return 0;
}

// (what): records that the event has happened.
int happened(lua_State* L) {
  Host::of(L).recorder.happen(luaL_checkstring(L, 1));
  return 0;
}

int count(lua_State* L) {
  Host& host = Host::of(L);
  host.limited.insert(host.owners[host.running]);
  host.recorder.count(std::string(luaL_checkstring(L, 1)) + " " + luaL_checkstring(L, 2));
  return 0;
}

int problem(lua_State* L) {
  Host& host = Host::of(L);
  const auto owner = size_t(luaL_checknumber(L, 1));
  const char* const text = luaL_optstring(L, 2, "error");
  const InstanceId script = owner < host.owners.size() ? host.owners[owner] : kNoInstance;
  host.noteError(script, text);
  const bool isRefused = !host.refused.empty() && std::string_view(text).ends_with(host.refused);
  const Failure failure = isRefused                       ? Failure::refused
                          : host.limited.contains(script) ? Failure::limited
                                                          : Failure::usual;
  host.recorder.problem(script, failure, host.withNames(std::string(Recorder::shortened(text))));
  return 0;
}

constexpr luaL_Reg kFunctions[] = {{"watched", watched}, {"tween", tween},   {"health", health},
                                   {"note", note},       {"driven", driven}, {"count", count},
                                   {"problem", problem}, {"heeded", heeded}, {"happened", happened},
                                   {nullptr, nullptr}};

}  // namespace
}  // namespace record_functions

void registerRecordFunctions(lua_State* L) {
  luaL_register(L, nullptr, record_functions::kFunctions);
}

}  // namespace obby::engine
