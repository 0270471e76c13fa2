// Numbered colours: scripts compare those of parts with them. Their value is a thing of the library
// whose name ends with the number.
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "import/format/brick_colors.h"
#include "import/luau/values.h"

namespace obby::importer::luau {
namespace {

constexpr std::string_view kPrefix = "BrickColor.new.";
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

Datum numbered(int64_t number) { return {Library{std::string(kPrefix) + std::to_string(number)}}; }

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

Datum colorOfPart(ColorRgb color) {
  const auto number = brickColorNumber(color);
  return number ? numbered(*number) : Datum{};
}

bool isNumberedColor(const Datum& datum) {
  const auto* library = datum.as<Library>();
  return library && library->name.rfind(kPrefix, 0) == 0;
}

Datum colorField(const Library& color, const std::string& name) {
  const int64_t number = std::strtoll(color.name.c_str() + kPrefix.size(), nullptr, 10);
  if (name == "Number") return {double(number)};
  for (const NameRow& row : kNames)
    if (name == "Name" && row.number == number) return {std::string(row.name)};
  return {};
}

}  // namespace obby::importer::luau
