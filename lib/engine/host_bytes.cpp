// Host functions that convert numbers to and from little-endian bytes.
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "engine/host.h"

namespace obby::engine {
namespace byte_functions {
namespace {

constexpr size_t kMaxBytes = 16;

bool isReal(const char* kind) { return kind[0] == 'f'; }

template <class T>
std::string bytesOfReal(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

template <class T>
double realOf(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return double(value);
}

static_assert(std::endian::native == std::endian::little);

// Returns the lowest bytes of a whole number, in two's complement.
std::string bytesOfInteger(double value, size_t size) {
  constexpr double kByte = 256;
  std::string bytes;
  value = std::isfinite(value) ? std::floor(value) : 0;
  for (size_t i = 0; i < size; ++i) {
    const double rest = std::floor(value / kByte);
    bytes += char(uint8_t(value - rest * kByte));
    value = rest;
  }
  return bytes;
}

double integerFrom(std::string_view bytes, bool isSigned) {
  double value = 0, unit = 1;
  for (const char byte : bytes) {
    value += unit * double(uint8_t(byte));
    unit *= 256;
  }
  const bool isNegative = isSigned && !bytes.empty() && (uint8_t(bytes.back()) & 0x80) != 0;
  return isNegative ? value - unit : value;
}

// (kind, size, value): returns the bytes. Kind "f" is a real number of 4 or 8 bytes, any other kind
// is a whole number.
int bytesOf(lua_State* L) {
  const size_t size = size_t(luaL_checkint(L, 2));
  const double value = luaL_checknumber(L, 3);
  if (size > kMaxBytes) return luaL_error(L, "a number cannot have %d bytes", int(size));
  const std::string bytes = !isReal(luaL_checkstring(L, 1)) ? bytesOfInteger(value, size)
                            : size == sizeof(float)         ? bytesOfReal(float(value))
                                                            : bytesOfReal(value);
  lua_pushlstring(L, bytes.data(), bytes.size());
  return 1;
}

// (kind, bytes): returns the number. Kind "i" is signed.
int numberOf(lua_State* L) {
  const char* const kind = luaL_checkstring(L, 1);
  size_t size = 0;
  const char* const bytes = luaL_checklstring(L, 2, &size);
  double value = 0;
  if (!isReal(kind))
    value = integerFrom({bytes, size}, kind[0] == 'i');
  else if (size == sizeof(float))
    value = realOf<float>(bytes);
  else if (size == sizeof(double))
    value = realOf<double>(bytes);
  lua_pushnumber(L, value);
  return 1;
}

constexpr luaL_Reg kFunctions[] = {
    {"bytesOf", bytesOf}, {"numberOf", numberOf}, {nullptr, nullptr}};

}  // namespace
}  // namespace byte_functions

void registerByteFunctions(lua_State* L) { luaL_register(L, nullptr, byte_functions::kFunctions); }

}  // namespace obby::engine
