#include "engine/stage.h"

#include <set>

#include "base/check.h"
#include "engine/values/values.h"

namespace obby::engine {

Stage::Stage(const Document& document, const Settings& settings)
    : host_(std::make_unique<Host>(document, settings)) {
  load();
}

Stage::~Stage() = default;

void Stage::call(const char* name, int arguments, int results) {
  lua_State* const L = host_->vm.state();
  host_->vm.beginStretch();
  host_->use(L, "boot");
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
  lua_insert(L, -1 - arguments);
  const Result<void> done = host_->vm.call(arguments, results);
  if (!done) {
    host_->recorder.problem(kNoInstance, host_->withNames("boot." + std::string(name) + ": " + done.error().message));
    for (int i = 0; i < results; ++i) lua_pushnil(L);
  }
}

void Stage::load() {
  const Document& document = host_->document;
  call("begin", 0);
  instances_.assign(document.instances.size(), LUA_NOREF);
  for (InstanceId id = 0; id < document.instances.size(); ++id) loadInstance(id);
  for (InstanceId id = 0; id < document.instances.size(); ++id) loadReferences(id);
  for (const int reference : instances_) luaL_unref(host_->vm.state(), LUA_REGISTRYINDEX, reference);
  instances_.clear();
}

void Stage::loadInstance(InstanceId id) {
  lua_State* const L = host_->vm.state();
  const Instance& from = host_->document.instances[id];
  const auto push = [L](const std::string& text) { lua_pushlstring(L, text.data(), text.size()); };
  lua_pushnumber(L, id);
  push(from.className);
  push(from.name);
  if (from.parent == kNoInstance) lua_pushnil(L);
  else lua_pushnumber(L, from.parent);
  call("add", 4, 1);
  instances_[id] = luaL_ref(L, LUA_REGISTRYINDEX);
  const auto pushSelf = [&] { lua_rawgeti(L, LUA_REGISTRYINDEX, instances_[id]); };
  for (const auto& [name, value] : from.properties) {
    if (std::holds_alternative<std::monostate>(value) || std::holds_alternative<Ref>(value) ||
        std::holds_alternative<SharedBlob>(value))
      continue;
    pushSelf();
    push(name);
    pushValue(L, value);
    call("set", 3);
  }
  for (const auto& [name, value] : from.attributes) {
    pushSelf();
    push(name);
    pushValue(L, value);
    call("attribute", 3);
  }
  if (from.tags.empty()) return;
  pushSelf();
  lua_newtable(L);
  for (size_t i = 0; i < from.tags.size(); ++i) {
    push(from.tags[i]);
    lua_rawseti(L, -2, int(i + 1));
  }
  call("tags", 2);
}

void Stage::loadReferences(InstanceId id) {
  lua_State* const L = host_->vm.state();
  for (const auto& [name, value] : host_->document.instances[id].properties) {
    const Ref* const reference = std::get_if<Ref>(&value);
    if (!reference || reference->target == kNoInstance) continue;
    lua_rawgeti(L, LUA_REGISTRYINDEX, instances_[id]);
    lua_pushlstring(L, name.data(), name.size());
    lua_pushnumber(L, reference->target);
    call("setReference", 3);
  }
}

void Stage::start() {
  host_->recorder.begin();
  call("start", 0);
  call("join", 0);
}

void Stage::run(uint32_t frames) {
  for (uint32_t i = 0; i < frames && !isExhausted(); ++i) {
    host_->recorder.setTime(host_->recorder.seen().frames + 1);
    call("frame", 0);
  }
}

void Stage::stand(Vec3 feet, float yaw) {
  lua_State* const L = host_->vm.state();
  for (const float value : {feet.x, feet.y, feet.z, yaw}) lua_pushnumber(L, lua_Number(value));
  call("stand", 4);
}

void Stage::use(InstanceId target) {
  lua_pushnumber(host_->vm.state(), target);
  call("use", 1);
}

const Observation& Stage::observation() {
  lua_State* const L = host_->vm.state();
  PlayerState& player = host_->recorder.seen().player;
  player = {};
  call("look", 0, 7);
  if (const Vec3* const feet = toVector3(L, lua_gettop(L) - 6)) {
    const int top = lua_gettop(L);
    player.feet = *feet;
    player.health = lua_tonumber(L, top - 5);
    if (const Vec3* const velocity = toVector3(L, top - 4)) player.velocity = *velocity;
    player.walkSpeed = lua_tonumber(L, top - 3);
    player.jumpPower = lua_tonumber(L, top - 2);
    player.jumpHeight = lua_tonumber(L, top - 1);
    player.usesJumpPower = lua_toboolean(L, top) != 0;
    player.alive = player.health > 0;
  }
  lua_pop(L, 7);
  return host_->recorder.seen();
}

}  // namespace obby::engine
