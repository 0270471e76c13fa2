#include "engine/stage_player.h"

namespace obby::engine {

void StagePlayer::call(const char* module, const char* name, int arguments, int results) {
  host_->vm.beginStretch();
  const auto body = [&](lua_State* L) {
    host_->use(L, module);
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
    lua_insert(L, 1);
    lua_call(L, arguments, results);
    return results;
  };
  const Result<void> done = host_->vm.call(body, arguments, results);
  if (done) return;
  note(std::string(module) + "." + name, done.error());
  for (int i = 0; i < results; ++i) lua_pushnil(host_->vm.state());
}

void StagePlayer::note(const std::string& what, const Error& error) {
  host_->recorder.problem(kNoInstance, Failure::limited,
                          host_->withNames(what + ": " + error.message));
  host_->noteError(kNoInstance, error.message);
}

void StagePlayer::stand(Vec3 feet, float yaw) {
  lua_State* const L = host_->vm.state();
  for (const float value : {feet.x, feet.y, feet.z, yaw}) lua_pushnumber(L, lua_Number(value));
  call("probe", "stand", 4);
}

void StagePlayer::standAt(InstanceId part, bool inside, float share, int face, float speed) {
  lua_State* const L = host_->vm.state();
  lua_pushnumber(L, part);
  lua_pushboolean(L, inside);
  lua_pushnumber(L, lua_Number(share));
  lua_pushnumber(L, face);
  lua_pushnumber(L, lua_Number(speed));
  call("probe", "standAt", 5);
}

void StagePlayer::standAway() { call("moves", "standAway", 0); }

void StagePlayer::touchAgain() { call("touch", "again", 0); }

void StagePlayer::leave() { call("probe", "leave", 0); }

void StagePlayer::revive() { call("probe", "revive", 0); }

void StagePlayer::unshield() { call("probe", "unshield", 0); }

void StagePlayer::die() { call("probe", "die", 0); }

double StagePlayer::numberOf(const char* name, const char* module, int arguments) {
  call(module, name, arguments, 1);
  const double value = lua_tonumber(host_->vm.state(), -1);
  lua_pop(host_->vm.state(), 1);
  return value;
}

void StagePlayer::takeOff() { call("probe", "takeOff", 0); }
void StagePlayer::fall() { call("probe", "fall", 0); }
void StagePlayer::land() { call("probe", "land", 0); }
void StagePlayer::pressJump() { call("probe", "pressJump", 0); }
bool StagePlayer::hearsJumps() { return numberOf("hearsJumps") > 0; }
bool StagePlayer::playerLives() { return numberOf("health") > 0; }
bool StagePlayer::use(InstanceId target) {
  lua_pushnumber(host_->vm.state(), target);
  return numberOf("use", "probe", 1) > 0;
}

void StagePlayer::release(InstanceId target) {
  lua_pushnumber(host_->vm.state(), target);
  call("probe", "release", 1);
}

void StagePlayer::drop(float height) {
  lua_pushnumber(host_->vm.state(), lua_Number(height));
  call("moves", "drop", 1);
}

bool StagePlayer::fly() { return numberOf("fly", "moves") > 0; }

void StagePlayer::walk(bool on) {
  lua_pushboolean(host_->vm.state(), on);
  call("moves", "walk", 1);
}

void StagePlayer::enter(const char* state) {
  lua_pushstring(host_->vm.state(), state);
  call("moves", "enter", 1);
}

}  // namespace obby::engine
