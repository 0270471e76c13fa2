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

struct NameRow {
  std::string_view name;
  int64_t number;
};

// Those that makers use; what another name means is not told.
// clang-format off
constexpr NameRow kNames[] = {
    {"White", 1}, {"Brick yellow", 5}, {"Nougat", 18}, {"Bright red", 21}, {"Bright blue", 23},
    {"Bright yellow", 24}, {"Black", 26}, {"Dark green", 28}, {"Bright green", 37},
    {"Light blue", 45}, {"Medium blue", 102}, {"Bright violet", 104}, {"Bright orange", 106},
    {"Earth green", 141}, {"Sand green", 151}, {"Reddish brown", 192}, {"Medium stone grey", 194},
    {"Dark stone grey", 199}, {"Light stone grey", 208}, {"Brown", 217}, {"Crimson", 327},
    {"Institutional white", 1001}, {"Mid gray", 1002}, {"Really black", 1003},
    {"Really red", 1004}, {"Alder", 1006}, {"Dusty Rose", 1007}, {"Olive", 1008},
    {"New Yeller", 1009}, {"Really blue", 1010}, {"Navy blue", 1011}, {"Deep blue", 1012},
    {"Cyan", 1013}, {"CGA brown", 1014}, {"Magenta", 1015}, {"Pink", 1016}, {"Teal", 1018},
    {"Toothpaste", 1019}, {"Lime green", 1020}, {"Camo", 1021}, {"Grime", 1022},
    {"Lavender", 1023}, {"Pastel light blue", 1024}, {"Pastel orange", 1025},
    {"Pastel violet", 1026}, {"Pastel blue-green", 1027}, {"Pastel green", 1028},
    {"Pastel yellow", 1029}, {"Pastel brown", 1030}, {"Royal purple", 1031}, {"Hot pink", 1032},
};
// clang-format on

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
  for (const NameRow& row : kNames)
    if (text && row.name == *text) return numbered(row.number);
  return {};
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
  for (const NameRow& row : kNames)
    if (name == "Name" && row.number == number) return {std::string(row.name)};
  return {};
}

}  // namespace obby::importer::luau
