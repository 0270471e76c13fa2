// Host functions for numbers, colours, materials and easing, and for the libraries bit32 and utf8.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <new>

#include "engine/host.h"
#include "engine/values/brick_colors.h"
#include "engine/values/color.h"
#include "engine/values/materials.h"
#include "engine/values/noise.h"
#include "engine/values/rotations.h"
#include "engine/values/values.h"
#include "level/motion_tables.h"

namespace obby::engine {
namespace value_functions {
namespace {

int pushNumber(lua_State* L, double value) {
  lua_pushnumber(L, value);
  return 1;
}

int single(lua_State* L) { return pushNumber(L, double(float(luaL_checknumber(L, 1)))); }
int truncated(lua_State* L) { return pushNumber(L, std::trunc(luaL_checknumber(L, 1))); }

int noise(lua_State* L) {
  return pushNumber(L, double(perlin(float(luaL_checknumber(L, 1)), float(luaL_optnumber(L, 2, 0)),
                                     float(luaL_optnumber(L, 3, 0)))));
}

// (share, style, direction): returns the eased share.
int ease(lua_State* L) {
  const auto style = schema::Easing(luaL_checkint(L, 2));
  const auto direction = schema::EasingDirection(luaL_checkint(L, 3));
  return pushNumber(L, level::ease(style, direction, luaL_checknumber(L, 1)));
}

// (pose): returns the pose with an orthonormal rotation, as parts store it. Products of many
// rotations drift.
int rigid(lua_State* L) {
  constexpr float kSlack = 1e-6f;
  const Pose pose = checkCFrame(L, 1);
  const Mat3& r = pose.rotation;
  const float off =
      std::max({absf(dot(r.x, r.x) - 1), absf(dot(r.y, r.y) - 1), absf(dot(r.z, r.z) - 1),
                absf(dot(r.x, r.y)), absf(dot(r.y, r.z)), absf(dot(r.x, r.z))});
  lua_settop(L, 1);
  if (off > kSlack) push(L, Pose{pose.position, orthonormal(r)});
  return 1;
}

// (number): returns the red, green and blue (0 to 255) and the name of a BrickColor.
int brickColorOf(lua_State* L) {
  const auto number = integerOf<int64_t>(luaL_checknumber(L, 1));
  const ColorRgb color = brickColor(number);
  for (const uint8_t channel : {color.r, color.g, color.b}) lua_pushnumber(L, channel);
  const std::string name = brickColorName(number);
  lua_pushlstring(L, name.data(), name.size());
  return 4;
}
int nearestBrickColor(lua_State* L) {
  const ColorRgb color = colorFromUnit(float(luaL_checknumber(L, 1)), float(luaL_checknumber(L, 2)),
                                       float(luaL_checknumber(L, 3)));
  return pushNumber(L, double(nearestBrickColorNumber(color)));
}
int brickNumber(lua_State* L) {
  const auto number = brickColorNamed(luaL_checkstring(L, 1));
  return number ? pushNumber(L, double(*number)) : 0;
}
int isBrickColor(lua_State* L) {
  const double number = lua_tonumber(L, 1);
  const bool whole = number == std::floor(number) && number >= 1 && number < 1e6;
  lua_pushboolean(L, whole && brickColorNumber(brickColor(int64_t(number))) == int64_t(number));
  return 1;
}
int paletteNumber(lua_State* L) {
  return pushNumber(L, double(paletteColor(integerOf<size_t>(luaL_checknumber(L, 1)))));
}

int material(lua_State* L) {
  const PhysicalProperties p = materialProperties(integerOf<uint32_t>(luaL_checknumber(L, 1)));
  for (const float value :
       {p.density, p.friction, p.elasticity, p.frictionWeight, p.elasticityWeight})
    lua_pushnumber(L, lua_Number(value));
  return 5;
}

int random(lua_State* L) {
  Host::of(L).recorder.noteDraw();
  return pushNumber(L, Host::of(L).random.share());
}
// Returns a generator for a seed. A seed with a fraction, or larger than a developer would type, is
// assumed to come from a clock. Any other seed gives the same numbers in each game.
Random seededRandom(lua_State* L) {
  constexpr double kMaxTyped = 1e8;
  const double seed = luaL_checknumber(L, 1);
  const auto whole = uint64_t(integerOf<int64_t>(seed));
  if (std::abs(seed) <= kMaxTyped && seed == std::floor(seed)) return Random(whole);
  Host& host = Host::of(L);
  host.recorder.noteDraw();
  return Random(whole + host.settings.seed, host.settings.draws);
}
int randomSeed(lua_State* L) {
  Host::of(L).random = seededRandom(L);
  return 0;
}
Random& randomAt(lua_State* L) {
  // Scripts have other userdata, but none of this size.
  if (lua_type(L, 1) != LUA_TUSERDATA || lua_objlen(L, 1) != sizeof(Random))
    luaL_typerror(L, 1, "Random");
  return *static_cast<Random*>(lua_touserdata(L, 1));
}
int newRandom(lua_State* L) {
  new (lua_newuserdata(L, sizeof(Random))) Random(seededRandom(L));
  return 1;
}
int nextRandom(lua_State* L) { return pushNumber(L, randomAt(L).share()); }
int copyRandom(lua_State* L) {
  const Random copy = randomAt(L);
  new (lua_newuserdata(L, sizeof(Random))) Random(copy);
  return 1;
}

// Returns the time of a clock that advances a little with every call, so that a loop that waits for
// it ends.
int tinySteps(lua_State* L) {
  constexpr double kStep = 1e-6;
  return pushNumber(L, Host::of(L).tinySteps += kStep);
}

int date(lua_State* L) {
  const std::string format = luaL_checkstring(L, 1);
  const auto when = integerOf<std::time_t>(luaL_checknumber(L, 2));
  std::tm parts{};
  gmtime_r(&when, &parts);
  const bool table = format.find("*t") != std::string::npos;
  if (!table) {
    char text[128];
    const size_t size =
        format.size() < 32 ? std::strftime(text, sizeof text, format.c_str(), &parts) : 0;
    lua_pushlstring(L, text, size);
    return 1;
  }
  lua_newtable(L);
  const auto set = [L](const char* name, double value) {
    lua_pushnumber(L, value);
    lua_setfield(L, -2, name);
  };
  set("year", parts.tm_year + 1900.0);
  set("month", parts.tm_mon + 1);
  set("day", parts.tm_mday);
  set("hour", parts.tm_hour);
  set("min", parts.tm_min);
  set("sec", parts.tm_sec);
  set("wday", parts.tm_wday + 1);
  set("yday", parts.tm_yday + 1);
  return 1;
}

// (table): returns the seconds since 1970 of a date in UTC, in the format of os.time.
int timeOf(lua_State* L) {
  static constexpr double kMax = 1e9;
  luaL_checktype(L, 1, LUA_TTABLE);
  const auto field = [L](const char* name, int usual) {
    lua_getfield(L, 1, name);
    const int value = int(std::fmin(std::fmax(luaL_optnumber(L, -1, usual), -kMax), kMax));
    lua_pop(L, 1);
    return value;
  };
  constexpr int kNoon = 12, kTmYear = 1900;
  std::tm parts{};
  parts.tm_year = field("year", 1970) - kTmYear;
  parts.tm_mon = field("month", 1) - 1;
  parts.tm_mday = field("day", 1);
  parts.tm_hour = field("hour", kNoon);
  parts.tm_min = field("min", 0);
  parts.tm_sec = field("sec", 0);
  return pushNumber(L, double(timegm(&parts)));
}

constexpr luaL_Reg kFunctions[] = {{"single", single},
                                   {"truncated", truncated},
                                   {"noise", noise},
                                   {"ease", ease},
                                   {"rigid", rigid},
                                   {"brickColor", brickColorOf},
                                   {"nearestBrickColor", nearestBrickColor},
                                   {"brickNumber", brickNumber},
                                   {"isBrickColor", isBrickColor},
                                   {"paletteNumber", paletteNumber},
                                   {"material", material},
                                   {"random", random},
                                   {"randomSeed", randomSeed},
                                   {"newRandom", newRandom},
                                   {"nextRandom", nextRandom},
                                   {"copyRandom", copyRandom},
                                   {"tinySteps", tinySteps},
                                   {"date", date},
                                   {"timeOf", timeOf},
                                   {nullptr, nullptr}};

struct ValuePusher {
  lua_State* L;

  void operator()(bool value) const { lua_pushboolean(L, value); }
  void operator()(int64_t value) const { lua_pushnumber(L, lua_Number(value)); }
  void operator()(double value) const { lua_pushnumber(L, value); }
  void operator()(const std::string& value) const {
    lua_pushlstring(L, value.data(), value.size());
  }
  void operator()(const EnumItem& value) const { lua_pushnumber(L, value.value); }
  void operator()(Vec3 value) const { push(L, value); }
  void operator()(const Pose& value) const { push(L, value); }
  void operator()(ColorRgb color) const {
    call("Color3", "fromRGB", {double(color.r), double(color.g), double(color.b)});
  }
  void operator()(const PhysicalProperties& p) const {
    if (!p.custom) return lua_pushnil(L);
    call("PhysicalProperties", "new",
         {double(p.density), double(p.friction), double(p.elasticity), double(p.frictionWeight),
          double(p.elasticityWeight)});
  }
  void operator()(const UDim& value) const {
    call("UDim", "new", {double(value.scale), double(value.offset)});
  }
  void operator()(const NumberRange& value) const {
    call("NumberRange", "new", {double(value.min), double(value.max)});
  }
  template <class Other>
  void operator()(const Other&) const {
    lua_pushnil(L);
  }

  // Calls datatypes.globals[library][maker](numbers...).
  void call(const char* library, const char* maker, std::initializer_list<double> numbers) const {
    Host::of(L).use(L, "datatypes");
    lua_getfield(L, -1, "globals");
    lua_getfield(L, -1, library);
    lua_getfield(L, -1, maker);
    for (const double number : numbers) lua_pushnumber(L, number);
    lua_call(L, int(numbers.size()), 1);
    lua_insert(L, -4);  // below datatypes, globals and the library
    lua_pop(L, 3);
  }
};

}  // namespace
}  // namespace value_functions

void pushValue(lua_State* L, const Value& value) {
  std::visit(value_functions::ValuePusher{L}, value);
}

void registerValueFunctions(lua_State* L) {
  luaL_register(L, nullptr, value_functions::kFunctions);
  lua_newtable(L);
  registerBits(L);
  lua_setfield(L, -2, "bit32");
  lua_newtable(L);
  registerCharacters(L);
  lua_setfield(L, -2, "utf8");
}

}  // namespace obby::engine
