// Colours: scripts compare those of parts with them. Their value is a thing of the library whose
// name ends with the number of a BrickColor, or with 0xRRGGBB of a Color3.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/values/brick_colors.h"
#include "engine/values/color.h"
#include "import/luau/values.h"

namespace obby::importer::luau {
namespace {

constexpr std::string_view kNumbered = "BrickColor.new.";
constexpr std::string_view kExact = "Color3.new.";
constexpr double kHighest = 10000;  // above all numbers

Datum named(std::string_view kind, int64_t number) {
  return {Library{std::string(kind) + std::to_string(number)}};
}

Datum numbered(int64_t number) { return named(kNumbered, number); }

// The number in the name of a colour of that kind; nothing: it is of another.
std::optional<int64_t> numberIn(const Library& color, std::string_view kind) {
  if (color.name.rfind(kind, 0) != 0) return std::nullopt;
  return std::strtoll(color.name.c_str() + kind.size(), nullptr, 10);
}

// As parts keep it; nothing: between two of those, or outside of them.
std::optional<uint8_t> channelOf(const Datum& given, double full) {
  constexpr double kSlack = 1e-3;
  const auto* number = given.as<double>();
  const double value = number ? *number * 255 / full : -1;
  if (!(value >= 0 && value <= 255) || std::abs(value - std::round(value)) > kSlack)
    return std::nullopt;
  return uint8_t(std::lround(value));
}

Datum exactField(ColorRgb color, const std::string& name) {
  if (name == "R" || name == "r") return {color.r / 255.0};
  if (name == "G" || name == "g") return {color.g / 255.0};
  if (name == "B" || name == "b") return {color.b / 255.0};
  return {};
}

}  // namespace

Datum colorGiven(const Datum& given) {
  if (const auto* number = given.as<double>()) {
    const bool whole = *number >= 1 && *number < kHighest && *number == std::floor(*number);
    const int64_t asked = whole ? int64_t(*number) : 0;
    return whole && brickColorNumber(brickColor(asked)) == asked ? numbered(asked) : Datum{};
  }
  const auto* text = given.as<std::string>();
  const auto known = text ? brickColorNamed(*text) : std::nullopt;
  return known ? numbered(*known) : Datum{};
}

Datum colorMade(const std::vector<Datum>& channels, double full) {
  uint8_t made[3] = {0, 0, 0};
  for (size_t i = 0; i < 3 && i < channels.size(); ++i) {
    const auto channel = channelOf(channels[i], full);
    if (!channel) return {};
    made[i] = *channel;
  }
  return exactColor({made[0], made[1], made[2]});
}

Datum numberedColor(ColorRgb color) {
  const auto number = brickColorNumber(color);
  return number ? numbered(*number) : Datum{};
}

Datum exactColor(ColorRgb color) { return named(kExact, packedFrom(color)); }

bool isColor(const Datum& datum) {
  const auto* library = datum.as<Library>();
  return library && (numberIn(*library, kNumbered) || numberIn(*library, kExact));
}

Datum colorField(const Library& color, const std::string& name) {
  if (const auto rgb = numberIn(color, kExact))
    return exactField(colorFromPacked(uint32_t(*rgb)), name);
  const int64_t number = numberIn(color, kNumbered).value_or(0);
  if (name == "Number") return {double(number)};
  if (name == "Color") return exactColor(brickColor(number));
  const std::string known = brickColorName(number);
  return name == "Name" && brickColorNamed(known) ? Datum{known} : Datum{};
}

}  // namespace obby::importer::luau
