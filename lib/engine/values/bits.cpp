// The libraries bit32 and utf8.
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "engine/values/values.h"

namespace obby::engine {
namespace bits {
namespace {

uint32_t bitsAt(lua_State* L, int index) {
  const double value = std::fmod(std::floor(luaL_checknumber(L, index)), 4294967296.0);
  return uint32_t(integerOf<int64_t>(value < 0 ? value + 4294967296.0 : value));
}
int pushBits(lua_State* L, uint32_t value) {
  lua_pushnumber(L, lua_Number(value));
  return 1;
}

template <class Of>
int fold(lua_State* L, uint32_t start, Of of) {
  for (int i = 1; i <= lua_gettop(L); ++i) start = of(start, bitsAt(L, i));
  return pushBits(L, start);
}
int band(lua_State* L) {
  return fold(L, ~0u, [](uint32_t a, uint32_t b) { return a & b; });
}
int bor(lua_State* L) {
  return fold(L, 0, [](uint32_t a, uint32_t b) { return a | b; });
}
int bxor(lua_State* L) {
  return fold(L, 0, [](uint32_t a, uint32_t b) { return a ^ b; });
}
int bnot(lua_State* L) { return pushBits(L, ~bitsAt(L, 1)); }
int btest(lua_State* L) {
  band(L);
  lua_pushboolean(L, lua_tonumber(L, -1) != 0);
  return 1;
}

uint32_t shifted(uint32_t value, int by) {
  if (by <= -32 || by >= 32) return 0;
  return by >= 0 ? value << by : value >> -by;
}
// Returns a shift clamped to -32..32: larger ones have the same result, and these can be negated.
int shiftAt(lua_State* L, int index) {
  return int(std::fmin(std::fmax(luaL_checknumber(L, index), -32), 32));
}
int lshift(lua_State* L) { return pushBits(L, shifted(bitsAt(L, 1), shiftAt(L, 2))); }
int rshift(lua_State* L) { return pushBits(L, shifted(bitsAt(L, 1), -shiftAt(L, 2))); }
int arshift(lua_State* L) {
  const auto value = int32_t(bitsAt(L, 1));
  const int by = shiftAt(L, 2);
  return pushBits(L,
                  by < 0 ? shifted(uint32_t(value), -by) : uint32_t(value >> (by > 31 ? 31 : by)));
}
int lrotate(lua_State* L) { return pushBits(L, std::rotl(bitsAt(L, 1), luaL_checkint(L, 2))); }
int rrotate(lua_State* L) { return pushBits(L, std::rotr(bitsAt(L, 1), luaL_checkint(L, 2))); }

// Returns the mask of `width` bits. Raises an error if the field exceeds the word's 32 bits.
uint32_t maskAt(lua_State* L, int field, int index) {
  const int width = luaL_optint(L, index, 1);
  if (field < 0 || width < 1 || field > 31 || width > 32 - field)
    luaL_error(L, "trying to access non-existent bits");
  return width == 32 ? ~0u : (1u << width) - 1;
}
int extract(lua_State* L) {
  const int field = luaL_checkint(L, 2);
  const uint32_t mask = maskAt(L, field, 3);
  return pushBits(L, (bitsAt(L, 1) >> field) & mask);
}
int replace(lua_State* L) {
  const int field = luaL_checkint(L, 3);
  const uint32_t mask = maskAt(L, field, 4);
  return pushBits(L, (bitsAt(L, 1) & ~(mask << field)) | ((bitsAt(L, 2) & mask) << field));
}
int countlz(lua_State* L) { return pushBits(L, uint32_t(std::countl_zero(bitsAt(L, 1)))); }
int countrz(lua_State* L) { return pushBits(L, uint32_t(std::countr_zero(bitsAt(L, 1)))); }
int byteswap(lua_State* L) { return pushBits(L, __builtin_bswap32(bitsAt(L, 1))); }

constexpr luaL_Reg kBits[] = {
    {"band", band},       {"bor", bor},         {"bxor", bxor},         {"bnot", bnot},
    {"btest", btest},     {"lshift", lshift},   {"rshift", rshift},     {"arshift", arshift},
    {"lrotate", lrotate}, {"rrotate", rrotate}, {"extract", extract},   {"replace", replace},
    {"countlz", countlz}, {"countrz", countrz}, {"byteswap", byteswap}, {nullptr, nullptr}};

void appendCode(std::string& out, uint32_t code) {
  if (code < 0x80) {
    out += char(code);
  } else if (code < 0x800) {
    out += char(0xc0 | code >> 6);
    out += char(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    out += char(0xe0 | code >> 12);
    out += char(0x80 | (code >> 6 & 0x3f));
    out += char(0x80 | (code & 0x3f));
  } else {
    out += char(0xf0 | (code >> 18 & 7));
    out += char(0x80 | (code >> 12 & 0x3f));
    out += char(0x80 | (code >> 6 & 0x3f));
    out += char(0x80 | (code & 0x3f));
  }
}

int character(lua_State* L) {
  std::string out;
  for (int i = 1; i <= lua_gettop(L); ++i) appendCode(out, bitsAt(L, i));
  lua_pushlstring(L, out.data(), out.size());
  return 1;
}

bool continues(char byte) { return (byte & 0xc0) == 0x80; }

int characterCount(lua_State* L) {
  size_t size = 0;
  const char* const text = luaL_checklstring(L, 1, &size);
  int count = 0;
  for (size_t i = 0; i < size; ++i) count += continues(text[i]) ? 0 : 1;
  lua_pushnumber(L, count);
  return 1;
}

constexpr luaL_Reg kCharacters[] = {
    {"char", character}, {"len", characterCount}, {nullptr, nullptr}};

}  // namespace
}  // namespace bits

void registerBits(lua_State* L) { luaL_register(L, nullptr, bits::kBits); }

void registerCharacters(lua_State* L) {
  luaL_register(L, nullptr, bits::kCharacters);
  lua_pushliteral(L, "[%z\x01-\x7f\xc2-\xf4][\x80-\xbf]*");
  lua_setfield(L, -2, "charpattern");
}

}  // namespace obby::engine
