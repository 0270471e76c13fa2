#include "gen/recipe.h"

#include <fmt/format.h>

#include "gen/styles.h"
#include "level/record_values.h"

namespace obby::gen {
namespace {

using level::pathError;

constexpr uint32_t kMaxObstacles = 200;  // per level
constexpr float kMaxExcess = 100;        // studs

Status checkStyles(const std::vector<NamedNumber>& weights, const std::string& path,
                   bool inCourses) {
  float sum = 0;
  for (const NamedNumber& w : weights) {
    const std::string here = path + "." + w.name;
    OBBY_ASSIGN(const Style* style, styleNamed(w.name, here));
    if (inCourses && style->chains) {
      return pathError(here, "a course cannot be part of a course", "leave out this style");
    }
    if (!(w.value >= 0 && w.value <= 1e6f)) {
      return pathError(here, fmt::format("expected a weight from 0 to 1000000, found {}", w.value));
    }
    sum += w.value;
  }
  if (!weights.empty() && !(sum > 0)) {
    return pathError(path, "all weights are 0", "give a style a weight above 0");
  }
  return {};
}

Status checkRange(Range r, float min, float max, const std::string& path) {
  if (r.lo >= min && r.hi <= max && r.lo <= r.hi) return {};
  return pathError(
      path, fmt::format("expected a range between {} and {}, found {} to {}", min, max, r.lo, r.hi),
      r.lo > r.hi ? "give the smaller number first" : "");
}

Status checkSettings(const std::vector<Setting>& settings) {
  for (const Setting& s : settings) {
    const Parameter& p = *s.parameter;
    for (const float value : {s.easy, s.hard}) {
      if (value >= p.min && value <= p.max) continue;
      return pathError("parameters." + fullName(p),
                       fmt::format("expected {} to {}, found {}", p.min, p.max, value));
    }
  }
  return {};
}

Status checkCount(Count c, const std::string& path) {
  return checkRange({float(c.lo), float(c.hi)}, 1, kMaxObstacles, path);
}

}  // namespace

Status checkRecipe(const Recipe& recipe) {
  OBBY_RETURN_IF_ERROR(checkStyles(recipe.styles, "styles", false));
  OBBY_RETURN_IF_ERROR(checkStyles(recipe.courseStyles, "course.styles", true));
  OBBY_RETURN_IF_ERROR(checkSettings(recipe.parameters));
  OBBY_RETURN_IF_ERROR(checkRange(recipe.difficulty, 0, 1, "difficulty"));
  OBBY_RETURN_IF_ERROR(checkCount(recipe.obstacles, "obstacles"));
  OBBY_RETURN_IF_ERROR(checkCount(recipe.courseObstacles, "course.obstacles"));
  OBBY_RETURN_IF_ERROR(checkRange({recipe.courseFirst, recipe.courseFirst}, 0, 1, "course.first"));
  OBBY_RETURN_IF_ERROR(checkRange({recipe.turns, recipe.turns}, 0, 1, "turns"));
  OBBY_RETURN_IF_ERROR(checkRange({recipe.waypoints, recipe.waypoints}, 0, 1, "limits.waypoints"));
  OBBY_RETURN_IF_ERROR(checkRange({recipe.jumpLimits, recipe.jumpLimits}, 0, 1, "limits.jumps"));
  OBBY_RETURN_IF_ERROR(checkRange({recipe.timeLimits, recipe.timeLimits}, 0, 1, "limits.time"));
  return checkRange(recipe.excess, 0.5f, kMaxExcess, "excess");
}

}  // namespace obby::gen
