#include "level/select_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <unordered_set>

#include "base/spelling.h"
#include "level/record_values.h"

namespace obby::level {

namespace {

constexpr size_t kShown = 5;          // candidates in a hint
constexpr int kLongestEnd = 8;        // max path components in a selector that is the end of a path
constexpr float kGrowUp = 0.5f;       // studs
constexpr float kGrowSide = 1;        // studs
constexpr float kStandingHeight = 5;  // studs

// Returns a list of selectors that can be typed, one for each part.
std::string listParts(PartIndex& index, const std::vector<uint32_t>& parts) {
  std::string text;
  for (size_t i = 0; i < std::min(parts.size(), kShown); ++i) {
    text += fmt::format("{}'{}'", i > 0 ? ", " : "", selectorOf(index, parts[i]));
  }
  return parts.size() > kShown ? fmt::format("{}, and {} more", text, parts.size() - kShown) : text;
}

// Returns the indices of the names that contain `wanted`, or none if it is empty. All names are in
// lower case.
std::vector<uint32_t> having(const std::vector<std::string>& names, const std::string& wanted) {
  std::vector<uint32_t> out;
  for (uint32_t i = 0; !wanted.empty() && i < names.size(); ++i) {
    if (names[i].find(wanted) != std::string::npos) out.push_back(i);
  }
  return out;
}

// Returns the indices of the names that equal the one spelled most like `wanted`. All names are in
// lower case.
std::vector<uint32_t> spelledLike(const std::vector<std::string>& names,
                                  const std::string& wanted) {
  std::vector<uint32_t> out;
  const std::string near = wanted.empty() ? "" : nearestName(wanted, names);
  for (uint32_t i = 0; !near.empty() && i < names.size(); ++i) {
    if (names[i] == near) out.push_back(i);
  }
  return out;
}

// Lists similar parts for a hint, by their paths or else by the spelling of their names.
std::string similarParts(PartIndex& parts, const std::string& wanted) {
  std::vector<std::string> names, paths;
  for (const auto part : parts.level().getParts()) {
    names.push_back(lower(part.getName().cStr()));
    paths.push_back(lower(pathOf(part)));
  }
  const std::vector<uint32_t> similar = having(paths, wanted);
  return listParts(parts, similar.empty() ? spelledLike(names, wanted) : similar);
}

// Lists similar tags for a hint.
std::string similarTags(schema::Level::Reader level, const std::string& wanted) {
  std::vector<std::string> tags, lowered;
  std::unordered_set<std::string> seen;
  for (const auto part : level.getParts()) {
    for (const auto tag : part.getTags()) {
      const std::string text(tag.cStr(), tag.size());
      if (!seen.insert(text).second) continue;
      tags.push_back("#" + text);
      lowered.push_back(lower(text));
    }
  }
  std::vector<uint32_t> similar = having(lowered, wanted);
  if (similar.empty()) similar = spelledLike(lowered, wanted);
  std::vector<std::string> shown;
  for (size_t i = 0; i < std::min(similar.size(), kShown); ++i) shown.push_back(tags[similar[i]]);
  return fmt::format("{}", fmt::join(shown, ", "));
}

Error noPart(PartIndex& parts, const std::string& selector) {
  const schema::Level::Reader level = parts.level();
  const std::string wanted = lower(selector);
  std::string similar;
  if (wanted.starts_with("#")) similar = similarTags(level, wanted.substr(1));
  if (similar.empty()) similar = similarParts(parts, wanted);
  return makeError(
      fmt::format("no part of level '{}' is named '{}'", level.getName().cStr(), selector),
      similar.empty() ? "give a part by name, path, end of a path, GUID, #tag or "
                        "part:INDEX, or a box as x,y,z,sx,sy,sz"
                      : "similar: " + similar);
}

std::vector<uint32_t> matchName(PartIndex& parts, const std::string& name) {
  if (name.empty()) return {};
  auto found = parts.withGuid(name);
  if (found.empty()) found = parts.withPath(name);
  if (found.empty()) found = parts.withName(name);
  if (found.empty()) found = parts.withPathEnd(name);
  return found;
}

// Returns -1 if the selector is not of the form part:N.
int64_t indexFromText(const std::string& selector) {
  if (!selector.starts_with("part:")) return -1;
  int64_t index = -1;
  const char* end = selector.data() + selector.size();
  const auto [at, error] = std::from_chars(selector.data() + 5, end, index);
  return error == std::errc() && at == end ? index : -1;
}

// Returns true if the name means this part on the command line, and no other.
bool meansOnly(PartIndex& parts, const std::string& name, uint32_t part) {
  for (const char* other : {"#", "part:", "touch:"}) {
    if (name.starts_with(other)) return false;
  }
  const auto box = boxFromText(name);
  if (!box || *box) return false;
  const std::vector<uint32_t> found = matchName(parts, name);
  return found.size() == 1 && found.front() == part;
}

Quat rotationOf(schema::Part::Reader part) {
  const auto q = part.getRotation();
  return normalize(Quat{q.getX(), q.getY(), q.getZ(), q.getW()});
}

// Returns half the part's height in the world.
float halfHeight(schema::Part::Reader part) {
  return boundsOf(Pose{{}, toMat3(rotationOf(part))}, vec(part.getSize()) * 0.5f).hi.y;
}

}  // namespace

std::string selectorOf(PartIndex& parts, uint32_t part) {
  const auto record = parts.level().getParts()[part];
  const std::string name = record.getName(), path(pathOf(record));
  if (meansOnly(parts, name, part)) return name;
  size_t slash = path.size();
  for (int i = 0; i < kLongestEnd && slash > 0; ++i) {
    slash = path.rfind('/', slash - 1);
    if (slash == std::string::npos) break;
    std::string end = path.substr(slash + 1);
    if (meansOnly(parts, end, part)) return end;
  }
  return meansOnly(parts, path, part) ? path : fmt::format("part:{}", part);
}

Result<std::vector<uint32_t>> matchParts(PartIndex& parts, const std::string& selector) {
  const schema::Level::Reader level = parts.level();
  std::vector<uint32_t> found;
  if (const int64_t index = indexFromText(selector); index >= 0) {
    if (level.getParts().size() == 0) {
      return makeError(fmt::format("level '{}' has no parts", level.getName().cStr()));
    }
    if (index >= int64_t(level.getParts().size())) {
      return makeError(fmt::format("level '{}' has parts 0 to {}, but no part {}",
                                   level.getName().cStr(), level.getParts().size() - 1, index));
    }
    found.push_back(uint32_t(index));
  } else {
    found =
        selector.starts_with("#") ? parts.withTag(selector.substr(1)) : matchName(parts, selector);
  }
  if (found.empty()) return noPart(parts, selector);
  return found;
}

Result<std::vector<uint32_t>> matchParts(schema::Level::Reader level, const std::string& selector) {
  PartIndex parts(level);
  return matchParts(parts, selector);
}

Result<uint32_t> matchPart(PartIndex& parts, const std::string& selector) {
  OBBY_ASSIGN(const std::vector<uint32_t> found, matchParts(parts, selector));
  if (found.size() == 1) return found.front();
  const schema::Level::Reader level = parts.level();
  return makeError(
      fmt::format("expected the name of one part, but '{}' names {} parts of level '{}'", selector,
                  found.size(), level.getName().cStr()),
      "give one of " + listParts(parts, found));
}

Result<uint32_t> matchPart(schema::Level::Reader level, const std::string& selector) {
  PartIndex parts(level);
  return matchPart(parts, selector);
}

Result<std::optional<PlainRegion>> boxFromText(const std::string& text) {
  std::array<float, 6> v{};
  bool fits = true;  // true if the numbers fit into floats
  const char *at = text.data(), *end = text.data() + text.size();
  for (size_t i = 0; i < v.size(); ++i) {
    const auto [next, error] = std::from_chars(at, end, v[i]);
    const bool last = i + 1 == v.size(), isNumber = error != std::errc::invalid_argument;
    if (!isNumber || (last ? next != end : (next == end || *next != ','))) {
      return std::optional<PlainRegion>();
    }
    fits = fits && error == std::errc();
    at = next + 1;
  }
  if (!fits) {
    return makeError(fmt::format("the box '{}' has a number that is too large or too small", text));
  }
  for (const float value : v) {
    if (!std::isfinite(value))
      return makeError(fmt::format("the box '{}' has a number that is not finite", text));
  }
  if (!(v[3] > 0 && v[4] > 0 && v[5] > 0)) {
    return makeError(fmt::format("the sizes of the box '{}' must be above 0", text),
                     "give the box as x,y,z,sx,sy,sz: centre and size in studs");
  }
  return std::optional<PlainRegion>({text, {v[0], v[1], v[2]}, {}, {v[3], v[4], v[5]}});
}

void fillBox(schema::Region::Builder record, const PlainRegion& box) {
  set(record.initPosition(), box.position);
  set(record.initRotation(), box.rotation);
  set(record.initSize(), box.size);
}

PlainRegion regionAround(schema::Part::Reader part) {
  const Quat q = rotationOf(part);
  const Mat3 axes = toMat3(q);
  const Vec3 size = vec(part.getSize());
  const Vec3 up{absf(axes.x.y), absf(axes.y.y), absf(axes.z.y)};  // upward component of each axis
  Vec3 grow{2 * kGrowSide, 2 * kGrowSide, 2 * kGrowSide}, lift;
  if (up.y >= up.x && up.y >= up.z) {
    grow.y = kGrowUp;
    lift = axes.y * (axes.y.y < 0 ? -1.0f : 1.0f);
  } else if (up.x >= up.z) {
    grow.x = kGrowUp;
    lift = axes.x * (axes.x.y < 0 ? -1.0f : 1.0f);
  } else {
    grow.z = kGrowUp;
    lift = axes.z * (axes.z.y < 0 ? -1.0f : 1.0f);
  }
  return {part.getName().cStr(), vec(part.getPosition()) + lift * (kGrowUp / 2), q, size + grow};
}

PlainRegion regionOnTop(schema::Part::Reader part) {
  const Vec3 up{0, halfHeight(part) + kStandingHeight / 2, 0};
  return {part.getName().cStr(), vec(part.getPosition()) + up, {}, {4, kStandingHeight, 4}};
}

}  // namespace obby::level
