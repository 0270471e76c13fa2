#include "gen/styles.h"

#include "base/spelling.h"
#include "gen/recipe.h"
#include "gen/styles/all.h"
#include "io/text.h"
#include "level/record_values.h"

namespace obby::gen {

namespace {

constexpr Style kCourse{.name = "course",
                        .description = "several other styles in a row, each harder than the last",
                        .build = nullptr,
                        .chains = true};

// Returns the style or parameter with a name, or null.
template <class Rows>
auto named(const Rows& rows, std::string_view name) -> decltype(&*rows.begin()) {
  for (const auto& row : rows) {
    if (name == row.name) return &row;
  }
  return nullptr;
}

template <class Rows>
Error unknown(const Rows& rows, std::string_view name, const std::string& path, std::string what,
              std::string list) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  const std::string near = nearestName(name, names);
  return level::pathError(path, std::move(what),
                          near.empty() ? std::move(list) : "did you mean " + near + "?");
}

}  // namespace

const std::vector<Style>& styles() {
  static const std::vector<Style> table = {
      kWalkwayStyle,    kGapsStyle,      kStairsUpStyle,
      kStairsDownStyle, kWallStyle,      kDoorwayStyle,
      kBeamStyle,       kKillFloorStyle, kCheckerboardStyle,
      kKillWallStyle,   kSpinnerStyle,   kLogRollStyle,
      kSliderStyle,     kElevatorStyle,  kCarrierStyle,
      kConveyorStyle,   kIceStyle,       kWedgeStyle,
      kTrussStyle,      kJumpPadStyle,   kVanishStyle,
      kBeatStyle,       kButtonStyle,    kPushBlockStyle,
      kForkStyle,       kDecoyStyle,     kZigzagStyle,
      kSpiralStyle,     kCourse,
  };
  return table;
}

const Style* findStyle(std::string_view name) { return named(styles(), name); }

// The difficulty must follow the style's name, since one name may be a prefix of another.
const Style* styleOfLevel(std::string_view levelName) {
  for (const Style& style : styles()) {
    const std::string begin = std::string(style.name) + '-';
    if (!levelName.starts_with(begin)) continue;
    const std::string_view rest = levelName.substr(begin.size());
    for (const NamedNumber& difficulty : namedDifficulties()) {
      if (rest.starts_with(difficulty.name + '-')) return &style;
    }
  }
  return nullptr;
}

Result<const Style*> styleNamed(std::string_view name, const std::string& path) {
  if (const Style* style = findStyle(name)) return style;
  return unknown(styles(), name, path, "there is no style " + io::quoted(name),
                 "see obby-gen --list");
}

Result<const Parameter*> parameterNamed(const Style& style, std::string_view name,
                                        const std::string& path) {
  if (const Parameter* p = named(style.parameters, name)) return p;
  return unknown(style.parameters, name, path,
                 std::string(style.name) + " has no parameter " + io::quoted(name),
                 "see obby-gen --list --style " + std::string(style.name));
}

std::string fullName(const Parameter& parameter) {
  for (const Style& s : styles()) {
    for (const Parameter& p : s.parameters) {
      if (&p == &parameter) return std::string(s.name) + '.' + p.name;
    }
  }
  return parameter.name;
}

}  // namespace obby::gen
