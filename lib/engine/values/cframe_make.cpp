// CFrame's constructors.
#include "engine/values/rotations.h"
#include "engine/values/values.h"

namespace obby::engine {
namespace cframe_make {
namespace {

float at(lua_State* L, int index) { return float(luaL_checknumber(L, index)); }

Vec3 vectorAt(lua_State* L, int first) {
  return {at(L, first), at(L, first + 1), at(L, first + 2)};
}

// Reads 7 numbers (a quaternion) or 12 (a matrix by rows).
Pose fromNumbers(lua_State* L, int count) {
  const Vec3 position = vectorAt(L, 1);
  if (count == 7)
    return {position, toMat3(normalize(Quat{at(L, 4), at(L, 5), at(L, 6), at(L, 7)}))};
  if (count != 12) return {position, {}};
  return {position, inverse(Mat3{vectorAt(L, 4), vectorAt(L, 7), vectorAt(L, 10)})};
}

int make(lua_State* L) {
  const int count = lua_gettop(L);
  if (count == 0 || lua_isnil(L, 1)) {
    push(L, Pose{});
  } else if (const Vec3* const position = toVector3(L, 1)) {
    const Vec3* const target = count > 1 ? toVector3(L, 2) : nullptr;
    push(L, Pose{*position, target ? looking(*target - *position, {0, 1, 0}) : Mat3{}});
  } else {
    push(L, fromNumbers(L, count));
  }
  return 1;
}

Angles anglesAt(lua_State* L) {
  return {luaL_optnumber(L, 1, 0), luaL_optnumber(L, 2, 0), luaL_optnumber(L, 3, 0)};
}
int angles(lua_State* L) {
  push(L, Pose{{}, fromAnglesXyz(anglesAt(L))});
  return 1;
}
int orientation(lua_State* L) {
  push(L, Pose{{}, fromAnglesYxz(anglesAt(L))});
  return 1;
}
int aboutAxis(lua_State* L) {
  push(L,
       Pose{{},
            rotationAbout(normalize(checkVector3(L, 1), Vec3{1, 0, 0}), luaL_checknumber(L, 2))});
  return 1;
}
int fromMatrix(lua_State* L) {
  const Vec3 position = checkVector3(L, 1), x = checkVector3(L, 2), y = checkVector3(L, 3);
  const Vec3* const z = toVector3(L, 4);
  push(L, Pose{position, {x, y, z ? *z : normalize(cross(x, y), Vec3{0, 0, 1})}});
  return 1;
}

Vec3 upAt(lua_State* L, int index) {
  const Vec3* const up = toVector3(L, index);
  return up ? *up : Vec3{0, 1, 0};
}
int lookAt(lua_State* L) {
  const Vec3 from = checkVector3(L, 1);
  push(L, Pose{from, looking(checkVector3(L, 2) - from, upAt(L, 3))});
  return 1;
}
int lookAlong(lua_State* L) {
  const Vec3 from = checkVector3(L, 1);
  push(L, Pose{from, looking(checkVector3(L, 2), upAt(L, 3))});
  return 1;
}

constexpr luaL_Reg kMakers[] = {{"new", make},
                                {"Angles", angles},
                                {"fromEulerAnglesXYZ", angles},
                                {"fromEulerAngles", angles},
                                {"fromOrientation", orientation},
                                {"fromEulerAnglesYXZ", orientation},
                                {"fromAxisAngle", aboutAxis},
                                {"fromMatrix", fromMatrix},
                                {"lookAt", lookAt},
                                {"lookAlong", lookAlong},
                                {nullptr, nullptr}};

}  // namespace
}  // namespace cframe_make

void openCFrameMakers(lua_State* L) {
  lua_newtable(L);
  luaL_register(L, nullptr, cframe_make::kMakers);
  push(L, Pose{});
  lua_setfield(L, -2, "identity");
  lua_setglobal(L, kCFrame.name);
}

}  // namespace obby::engine
