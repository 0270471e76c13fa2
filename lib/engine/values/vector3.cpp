// Vector3: members, operators and constructors.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>

#include "engine/values/values.h"

namespace obby::engine {
namespace vector3 {
namespace {

constexpr float kFuzzy = 1e-5f;

float number(lua_State* L, int index) { return float(luaL_checknumber(L, index)); }

Vec3 unit(Vec3 v) {
  const float size = length(v);
  return {v.x / size, v.y / size, v.z / size};  // NaN for zero, as in the engine
}

int dotMethod(lua_State* L) {
  lua_pushnumber(L, lua_Number(dot(checkVector3(L, 1), checkVector3(L, 2))));
  return 1;
}

int crossMethod(lua_State* L) {
  push(L, cross(checkVector3(L, 1), checkVector3(L, 2)));
  return 1;
}

int lerpMethod(lua_State* L) {
  const Vec3 a = checkVector3(L, 1), b = checkVector3(L, 2);
  push(L, a + (b - a) * number(L, 3));
  return 1;
}

int fuzzyMethod(lua_State* L) {
  const Vec3 a = checkVector3(L, 1), b = checkVector3(L, 2);
  const float epsilon = float(luaL_optnumber(L, 3, kFuzzy));
  const Vec3 gap = abs(a - b);
  const Vec3 limit = {epsilon * (1 + std::fabs(a.x)), epsilon * (1 + std::fabs(a.y)),
                      epsilon * (1 + std::fabs(a.z))};
  lua_pushboolean(L, gap.x <= limit.x && gap.y <= limit.y && gap.z <= limit.z);
  return 1;
}

int angleMethod(lua_State* L) {
  const Vec3 a = checkVector3(L, 1), b = checkVector3(L, 2), c = cross(a, b);
  double angle = std::atan2(double(length(c)), double(dot(a, b)));
  const Vec3* const axis = toVector3(L, 3);
  if (axis && dot(c, *axis) < 0) angle = -angle;
  lua_pushnumber(L, angle);
  return 1;
}

template <Vec3 (*kOf)(Vec3)>
int ofOne(lua_State* L) {
  push(L, kOf(checkVector3(L, 1)));
  return 1;
}

template <Vec3 (*kOf)(Vec3, Vec3)>
int ofTwo(lua_State* L) {
  push(L, kOf(checkVector3(L, 1), checkVector3(L, 2)));
  return 1;
}

Vec3 floorOf(Vec3 v) { return {std::floor(v.x), std::floor(v.y), std::floor(v.z)}; }
Vec3 ceilOf(Vec3 v) { return {std::ceil(v.x), std::ceil(v.y), std::ceil(v.z)}; }
Vec3 absOf(Vec3 v) { return abs(v); }
float sign(float x) { return x > 0 ? 1.0f : x < 0 ? -1.0f : 0.0f; }
Vec3 signOf(Vec3 v) { return {sign(v.x), sign(v.y), sign(v.z)}; }
Vec3 minOf(Vec3 a, Vec3 b) { return min(a, b); }
Vec3 maxOf(Vec3 a, Vec3 b) { return max(a, b); }

constexpr luaL_Reg kMethods[] = {
    {"Dot", dotMethod},        {"Cross", crossMethod},   {"Lerp", lerpMethod},
    {"FuzzyEq", fuzzyMethod},  {"isClose", fuzzyMethod}, {"Angle", angleMethod},
    {"Floor", ofOne<floorOf>}, {"Ceil", ofOne<ceilOf>},  {"Abs", ofOne<absOf>},
    {"Sign", ofOne<signOf>},   {"Min", ofTwo<minOf>},    {"Max", ofTwo<maxOf>},
    {"dot", dotMethod},        {"cross", crossMethod},   {"lerp", lerpMethod},
    {nullptr, nullptr}};

int index(lua_State* L) {
  const Vec3& v = checkVector3(L, 1);
  const char* const key = luaL_checkstring(L, 2);
  if (key[0] != '\0' && key[1] == '\0') {
    const char axis = char(key[0] | 0x20);
    if (axis >= 'x' && axis <= 'z') {
      lua_pushnumber(L, lua_Number(component(v, axis - 'x')));
      return 1;
    }
  }
  if (std::strcmp(key, "Magnitude") == 0 || std::strcmp(key, "magnitude") == 0) {
    lua_pushnumber(L, lua_Number(length(v)));
    return 1;
  }
  if (std::strcmp(key, "Unit") == 0 || std::strcmp(key, "unit") == 0) {
    push(L, unit(v));
    return 1;
  }
  return methodNamed(L, kVector3);
}

// Returns a vector. A number counts for all three components.
Vec3 operand(lua_State* L, int index) {
  if (const Vec3* const vector = toVector3(L, index)) return *vector;
  const float value = number(L, index);
  return {value, value, value};
}

int add(lua_State* L) {
  push(L, checkVector3(L, 1) + checkVector3(L, 2));
  return 1;
}
int subtract(lua_State* L) {
  push(L, checkVector3(L, 1) - checkVector3(L, 2));
  return 1;
}
int multiply(lua_State* L) {
  push(L, mul(operand(L, 1), operand(L, 2)));
  return 1;
}
int divide(lua_State* L) {
  const Vec3 a = operand(L, 1), b = operand(L, 2);
  push(L, Vec3{a.x / b.x, a.y / b.y, a.z / b.z});
  return 1;
}
int floorDivide(lua_State* L) {
  const Vec3 a = operand(L, 1), b = operand(L, 2);
  push(L, floorOf({a.x / b.x, a.y / b.y, a.z / b.z}));
  return 1;
}
int negate(lua_State* L) {
  push(L, -checkVector3(L, 1));
  return 1;
}
int equal(lua_State* L) {
  const Vec3 *const a = toVector3(L, 1), *const b = toVector3(L, 2);
  lua_pushboolean(L, a && b && *a == *b);
  return 1;
}
int toText(lua_State* L) {
  const Vec3& v = checkVector3(L, 1);
  char text[96];
  std::snprintf(text, sizeof text, "%.7g, %.7g, %.7g", double(v.x), double(v.y), double(v.z));
  lua_pushstring(L, text);
  return 1;
}

constexpr luaL_Reg kMeta[] = {{"__add", add},    {"__sub", subtract},     {"__mul", multiply},
                              {"__div", divide}, {"__idiv", floorDivide}, {"__unm", negate},
                              {"__eq", equal},   {"__tostring", toText},  {nullptr, nullptr}};

int make(lua_State* L) {
  push(L, Vec3{float(luaL_optnumber(L, 1, 0)), float(luaL_optnumber(L, 2, 0)),
               float(luaL_optnumber(L, 3, 0))});
  return 1;
}

struct Constant {
  const char* name;
  Vec3 value;
};
constexpr Constant kConstants[] = {{"zero", {0, 0, 0}},
                                   {"one", {1, 1, 1}},
                                   {"xAxis", {1, 0, 0}},
                                   {"yAxis", {0, 1, 0}},
                                   {"zAxis", {0, 0, 1}}};

}  // namespace
}  // namespace vector3

void push(lua_State* L, Vec3 value) { new (newValue(L, kVector3, sizeof(Vec3))) Vec3(value); }

const Vec3* toVector3(lua_State* L, int index) {
  return static_cast<const Vec3*>(toValue(L, index, kVector3, sizeof(Vec3)));
}

const Vec3& checkVector3(lua_State* L, int index) {
  const Vec3* const value = toVector3(L, index);
  if (!value) luaL_typerror(L, index, kVector3.name);
  return *value;
}

void openVector3(lua_State* L) {
  openType(L, kVector3, vector3::kMeta, vector3::kMethods, vector3::index);
  lua_newtable(L);
  lua_pushcfunction(L, vector3::make);
  lua_setfield(L, -2, "new");
  for (const vector3::Constant& constant : vector3::kConstants) {
    push(L, constant.value);
    lua_setfield(L, -2, constant.name);
  }
  lua_setglobal(L, kVector3.name);
}

}  // namespace obby::engine
