#include "engine/stage.h"

#include <cstdlib>

#include "base/check.h"
#include "engine/values/values.h"

namespace obby::engine {

Stage::Stage(const Document& document, const Settings& settings) : StagePlayer(document, settings) {
  load();
}

void Stage::read(const char* name, const std::function<void(lua_State*)>& body) {
  const Result<void> done = host_->vm.call([&](lua_State* L) { return body(L), 0; });
  if (!done) note(name, done.error());
}

void Stage::load() {
  const Document& document = host_->document;
  call("boot", "begin", 0);
  instances_.assign(document.instances.size(), LUA_NOREF);
  for (InstanceId id = 0; id < document.instances.size(); ++id)
    read("load", [&](lua_State*) { loadInstance(id); });
  for (InstanceId id = 0; id < document.instances.size(); ++id)
    read("load", [&](lua_State*) { loadReferences(id); });
  for (const int reference : instances_)
    luaL_unref(host_->vm.state(), LUA_REGISTRYINDEX, reference);
  instances_.clear();
}

void Stage::loadInstance(InstanceId id) {
  lua_State* const L = host_->vm.state();
  const Instance& from = host_->document.instances[id];
  noteWork();
  const auto push = [L](const std::string& text) { lua_pushlstring(L, text.data(), text.size()); };
  lua_pushnumber(L, id);
  push(from.className);
  push(from.name);
  if (from.parent == kNoInstance)
    lua_pushnil(L);
  else
    lua_pushnumber(L, from.parent);
  call("boot", "add", 4, 1);
  instances_[id] = luaL_ref(L, LUA_REGISTRYINDEX);
  const auto pushSelf = [&] { lua_rawgeti(L, LUA_REGISTRYINDEX, instances_[id]); };
  for (const auto& [name, value] : from.properties) {
    if (std::holds_alternative<std::monostate>(value) || std::holds_alternative<Ref>(value) ||
        std::holds_alternative<SharedBlob>(value))
      continue;
    pushSelf();
    push(name);
    pushValue(L, value);
    call("boot", "set", 3);
  }
  for (const auto& [name, value] : from.attributes) {
    pushSelf();
    push(name);
    pushValue(L, value);
    call("boot", "attribute", 3);
  }
  if (from.tags.empty()) return;
  pushSelf();
  lua_newtable(L);
  for (size_t i = 0; i < from.tags.size(); ++i) {
    push(from.tags[i]);
    lua_rawseti(L, -2, int(i + 1));
  }
  call("boot", "tags", 2);
}

void Stage::loadReferences(InstanceId id) {
  lua_State* const L = host_->vm.state();
  for (const auto& [name, value] : host_->document.instances[id].properties) {
    const Ref* const reference = std::get_if<Ref>(&value);
    if (!reference || reference->target == kNoInstance) continue;
    lua_rawgeti(L, LUA_REGISTRYINDEX, instances_[id]);
    lua_pushlstring(L, name.data(), name.size());
    lua_pushnumber(L, reference->target);
    call("boot", "setReference", 3);
  }
}

void Stage::start() {
  call("boot", "place", 0);
  host_->recorder.begin();
  call("boot", "start", 0);
  call("boot", "join", 0);
}

void Stage::run(uint32_t frames) {
  for (uint32_t i = 0; i < frames && !isExhausted(); ++i) {
    host_->recorder.setTime(host_->recorder.seen().frames + 1);
    call("boot", "frame", 0);
  }
}

bool Stage::isBusy() { return numberOf("waiting") > waiting_; }
bool Stage::sleeps() { return numberOf("asleep") > asleep_; }
bool Stage::isIdle() { return numberOf("idle") > 0; }

void Stage::restart() {
  forget();
  waiting_ = numberOf("waiting");
  asleep_ = numberOf("asleep");
}

std::vector<Probe> Stage::probes() {
  std::vector<Probe> all;
  read("probes", [&](lua_State* L) { readProbes(L, all); });
  return all;
}

void Stage::readProbes(lua_State* L, std::vector<Probe>& all) {
  call("probe", "targets", 0, 1);
  for (int i = 1; lua_istable(L, -1) && i <= int(lua_objlen(L, -1)); ++i) {
    lua_rawgeti(L, -1, i);
    lua_rawgeti(L, -1, 1);
    lua_rawgeti(L, -2, 2);
    lua_rawgeti(L, -3, 3);
    lua_rawgeti(L, -4, 4);
    Probe probe;
    probe.target = InstanceId(lua_tonumber(L, -4));
    probe.approach = Approach(int(lua_tonumber(L, -3)));
    probe.byPlace = lua_toboolean(L, -2) != 0;
    probe.listenerHash = uint64_t(lua_tonumber(L, -1));
    all.push_back(std::move(probe));
    lua_pop(L, 5);
  }
}

std::vector<MadePart> Stage::made() {
  std::vector<MadePart> all;
  read("made", [&](lua_State* L) { readMade(L, all); });
  return all;
}

void Stage::readMade(lua_State* L, std::vector<MadePart>& all) {
  call("made", "list", 0, 1);
  const auto text = [L](int i) {
    lua_rawgeti(L, -1, i);
    const char* const read = lua_tostring(L, -1);
    std::string copy = read ? read : "";
    lua_pop(L, 1);
    return copy;
  };
  for (int i = 1; lua_istable(L, -1) && i <= int(lua_objlen(L, -1)); ++i) {
    lua_rawgeti(L, -1, i);
    MadePart part;
    part.id = InstanceId(std::strtoul(text(1).c_str(), nullptr, 10));
    const std::string origin = text(2);
    if (!origin.empty()) part.origin = InstanceId(std::strtoul(origin.c_str(), nullptr, 10));
    part.className = text(3);
    part.name = text(4);
    lua_rawgeti(L, -1, 5);
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
      part.properties[lua_tostring(L, -2)] = plainAt(L, lua_gettop(L));
    lua_pop(L, 1);
    const std::string parent = text(6);
    if (!parent.empty()) part.parent = InstanceId(std::strtoul(parent.c_str(), nullptr, 10));
    lua_rawgeti(L, -1, 7);
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
      part.references[lua_tostring(L, -2)] = InstanceId(lua_tonumber(L, -1));
    lua_pop(L, 2);
    all.push_back(std::move(part));
  }
}

std::vector<std::string> Stage::groups() {
  std::vector<std::string> all;
  read("groups", [&](lua_State* L) {
    call("probe", "groups", 0, 1);
    for (int i = 1; lua_istable(L, -1) && i <= int(lua_objlen(L, -1)); ++i) {
      lua_rawgeti(L, -1, i);
      if (const char* const name = lua_tostring(L, -1)) all.emplace_back(name);
      lua_pop(L, 1);
    }
  });
  return all;
}

const Observation& Stage::observation() {
  lua_State* const L = host_->vm.state();
  PlayerState& player = host_->recorder.seen().player;
  player = {};
  constexpr int kValues = 11;
  call("probe", "look", 0, kValues);
  const int first = lua_gettop(L) - kValues + 1;
  if (const Vec3* const feet = toVector3(L, first)) {
    player.feet = *feet;
    player.health = lua_tonumber(L, first + 1);
    if (const Vec3* const velocity = toVector3(L, first + 2)) player.velocity = *velocity;
    player.walkSpeed = lua_tonumber(L, first + 3);
    player.jumpPower = lua_tonumber(L, first + 4);
    player.jumpHeight = lua_tonumber(L, first + 5);
    player.maxHealth = lua_tonumber(L, first + 6);
    player.usesJumpPower = lua_toboolean(L, first + 7) != 0;
    player.gravity = lua_tonumber(L, first + 8);
    player.lift = lua_tonumber(L, first + 9);
    player.stuck = lua_toboolean(L, first + 10) != 0;
    player.alive = player.health > 0;
  }
  lua_pop(L, kValues);
  return host_->recorder.seen();
}

}  // namespace obby::engine
