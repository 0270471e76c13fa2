// CFrame: members and operators. Constructors are in cframe_make.cpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "engine/values/rotations.h"
#include "engine/values/values.h"

namespace obby::engine {
namespace cframe {
namespace {

int inverseMethod(lua_State* L) {
  push(L, inverse(checkCFrame(L, 1)));
  return 1;
}

int lerpMethod(lua_State* L) {
  const Pose a = checkCFrame(L, 1), b = checkCFrame(L, 2);
  const float share = float(luaL_checknumber(L, 3));
  push(L, Pose{a.position + (b.position - a.position) * share,
               between(a.rotation, b.rotation, share)});
  return 1;
}

// Returns `of` applied to each argument, for methods with any number of arguments.
template <class Of>
int ofEach(lua_State* L, Of of) {
  const Pose self = checkCFrame(L, 1);
  const int count = std::max(lua_gettop(L) - 1, 1);
  luaL_checkstack(L, count, "too many arguments");
  for (int i = 0; i < count; ++i) of(self, i + 2);
  return count;
}

int toWorldSpace(lua_State* L) {
  return ofEach(L, [L](const Pose& self, int i) { push(L, self * checkCFrame(L, i)); });
}
int toObjectSpace(lua_State* L) {
  return ofEach(L, [L](const Pose& self, int i) { push(L, inverse(self) * checkCFrame(L, i)); });
}
int pointToWorldSpace(lua_State* L) {
  return ofEach(L, [L](const Pose& self, int i) { push(L, toWorld(self, checkVector3(L, i))); });
}
int pointToObjectSpace(lua_State* L) {
  return ofEach(L, [L](const Pose& self, int i) { push(L, toLocal(self, checkVector3(L, i))); });
}
int vectorToWorldSpace(lua_State* L) {
  return ofEach(L, [L](const Pose& self, int i) { push(L, self.rotation * checkVector3(L, i)); });
}
int vectorToObjectSpace(lua_State* L) {
  return ofEach(
      L, [L](const Pose& self, int i) { push(L, toLocal(self.rotation, checkVector3(L, i))); });
}

int components(lua_State* L) {
  const Pose& p = checkCFrame(L, 1);
  const float all[] = {p.position.x,   p.position.y,   p.position.z,   p.rotation.x.x,
                       p.rotation.y.x, p.rotation.z.x, p.rotation.x.y, p.rotation.y.y,
                       p.rotation.z.y, p.rotation.x.z, p.rotation.y.z, p.rotation.z.z};
  for (const float value : all) lua_pushnumber(L, lua_Number(value));
  return 12;
}

int pushAngles(lua_State* L, Angles angles) {
  lua_pushnumber(L, angles.x);
  lua_pushnumber(L, angles.y);
  lua_pushnumber(L, angles.z);
  return 3;
}
int toAnglesXyz(lua_State* L) { return pushAngles(L, anglesXyz(checkCFrame(L, 1).rotation)); }
int toOrientation(lua_State* L) { return pushAngles(L, anglesYxz(checkCFrame(L, 1).rotation)); }

int toAxisAngle(lua_State* L) {
  const AxisAngle turn = axisAngle(checkCFrame(L, 1).rotation);
  push(L, turn.axis);
  lua_pushnumber(L, turn.angle);
  return 2;
}

int orthonormalize(lua_State* L) {
  const Pose& p = checkCFrame(L, 1);
  push(L, Pose{p.position, orthonormal(p.rotation)});
  return 1;
}

// Returns the angle between two rotations, in radians.
int angleBetween(lua_State* L) {
  const Mat3 a = checkCFrame(L, 1).rotation, b = checkCFrame(L, 2).rotation;
  const float trace = dot(a.x, b.x) + dot(a.y, b.y) + dot(a.z, b.z);
  lua_pushnumber(L, std::acos(std::clamp((double(trace) - 1) / 2, -1.0, 1.0)));
  return 1;
}

int fuzzyEqual(lua_State* L) {
  const Pose a = checkCFrame(L, 1), b = checkCFrame(L, 2);
  const float epsilon = float(luaL_optnumber(L, 3, 1e-5));
  const auto near = [epsilon](Vec3 u, Vec3 v) {
    const Vec3 gap = abs(u - v);
    return std::max({gap.x, gap.y, gap.z}) <= epsilon;
  };
  lua_pushboolean(L, near(a.position, b.position) && near(a.rotation.x, b.rotation.x) &&
                         near(a.rotation.y, b.rotation.y) && near(a.rotation.z, b.rotation.z));
  return 1;
}

constexpr luaL_Reg kMethods[] = {{"Inverse", inverseMethod},
                                 {"inverse", inverseMethod},
                                 {"Lerp", lerpMethod},
                                 {"lerp", lerpMethod},
                                 {"ToWorldSpace", toWorldSpace},
                                 {"toWorldSpace", toWorldSpace},
                                 {"ToObjectSpace", toObjectSpace},
                                 {"toObjectSpace", toObjectSpace},
                                 {"PointToWorldSpace", pointToWorldSpace},
                                 {"pointToWorldSpace", pointToWorldSpace},
                                 {"PointToObjectSpace", pointToObjectSpace},
                                 {"pointToObjectSpace", pointToObjectSpace},
                                 {"VectorToWorldSpace", vectorToWorldSpace},
                                 {"vectorToWorldSpace", vectorToWorldSpace},
                                 {"VectorToObjectSpace", vectorToObjectSpace},
                                 {"vectorToObjectSpace", vectorToObjectSpace},
                                 {"GetComponents", components},
                                 {"components", components},
                                 {"ToEulerAnglesXYZ", toAnglesXyz},
                                 {"toEulerAnglesXYZ", toAnglesXyz},
                                 {"ToEulerAngles", toAnglesXyz},
                                 {"ToOrientation", toOrientation},
                                 {"toOrientation", toOrientation},
                                 {"ToEulerAnglesYXZ", toOrientation},
                                 {"ToAxisAngle", toAxisAngle},
                                 {"toAxisAngle", toAxisAngle},
                                 {"Orthonormalize", orthonormalize},
                                 {"FuzzyEq", fuzzyEqual},
                                 {"AngleBetween", angleBetween},
                                 {nullptr, nullptr}};

// Sets `out` to a member that is a vector; returns false for other keys.
bool vectorMember(const Pose& p, const std::string& key, Vec3& out) {
  const Mat3& r = p.rotation;
  if (key == "Position" || key == "p")
    out = p.position;
  else if (key == "LookVector" || key == "lookVector")
    out = -r.z;
  else if (key == "RightVector" || key == "rightVector" || key == "XVector")
    out = r.x;
  else if (key == "UpVector" || key == "upVector" || key == "YVector")
    out = r.y;
  else if (key == "ZVector")
    out = r.z;
  else
    return false;
  return true;
}

int index(lua_State* L) {
  const Pose& p = checkCFrame(L, 1);
  const std::string key = luaL_checkstring(L, 2);
  if (key.size() == 1) {
    const char axis = char(key[0] | 0x20);
    if (axis >= 'x' && axis <= 'z') {
      lua_pushnumber(L, lua_Number(component(p.position, axis - 'x')));
      return 1;
    }
  }
  if (Vec3 vector; vectorMember(p, key, vector)) {
    push(L, vector);
    return 1;
  }
  if (key == "Rotation") {
    push(L, Pose{{}, p.rotation});
    return 1;
  }
  return methodNamed(L, kCFrame);
}

int multiply(lua_State* L) {
  const Pose a = checkCFrame(L, 1);
  if (const Vec3* const point = toVector3(L, 2))
    push(L, toWorld(a, *point));
  else
    push(L, a * checkCFrame(L, 2));
  return 1;
}
int add(lua_State* L) {
  const Pose& a = checkCFrame(L, 1);
  push(L, Pose{a.position + checkVector3(L, 2), a.rotation});
  return 1;
}
int subtract(lua_State* L) {
  const Pose& a = checkCFrame(L, 1);
  push(L, Pose{a.position - checkVector3(L, 2), a.rotation});
  return 1;
}
int equal(lua_State* L) {
  const Pose *const a = toCFrame(L, 1), *const b = toCFrame(L, 2);
  lua_pushboolean(L, a && b && a->position == b->position && a->rotation.x == b->rotation.x &&
                         a->rotation.y == b->rotation.y && a->rotation.z == b->rotation.z);
  return 1;
}
int toText(lua_State* L) {
  const int count = components(L);
  std::string text;
  char buffer[32];
  for (int i = count; i > 0; --i) {
    std::snprintf(buffer, sizeof buffer, "%.7g", lua_tonumber(L, -i));
    text += (text.empty() ? "" : ", ") + std::string(buffer);
  }
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

constexpr luaL_Reg kMeta[] = {{"__mul", multiply}, {"__add", add},         {"__sub", subtract},
                              {"__eq", equal},     {"__tostring", toText}, {nullptr, nullptr}};

}  // namespace
}  // namespace cframe

void push(lua_State* L, const Pose& value) { new (newValue(L, kCFrame, sizeof(Pose))) Pose(value); }

const Pose* toCFrame(lua_State* L, int index) {
  return static_cast<const Pose*>(toValue(L, index, kCFrame, sizeof(Pose)));
}

const Pose& checkCFrame(lua_State* L, int index) {
  const Pose* const value = toCFrame(L, index);
  if (!value) luaL_typerror(L, index, kCFrame.name);
  return *value;
}

void openCFrame(lua_State* L) {
  openType(L, kCFrame, cframe::kMeta, cframe::kMethods, cframe::index);
  openCFrameMakers(L);
}

}  // namespace obby::engine
