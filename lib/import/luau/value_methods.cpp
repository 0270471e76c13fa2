// Fields and methods of vectors, poses, the timing of tweens, and texts.
#include <algorithm>
#include <cmath>

#include "import/luau/reader.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

Datum known(float n) { return std::isnan(n) ? Datum{} : Datum{double(n)}; }

Datum ofVector(const Vector& v, const std::string& name, const std::vector<Datum>& a) {
  if (name == "X" || name == "x") return known(v.value.x);
  if (name == "Y" || name == "y") return known(v.value.y);
  if (name == "Z" || name == "z") return known(v.value.z);
  if (name == "Magnitude" || name == "magnitude") return known(length(v.value));
  if (name == "Unit" || name == "unit") return vectorDatum(normalize(v.value, {0, 0, 0}));
  const auto* other = a.empty() ? nullptr : a[0].as<Vector>();
  if (name == "Dot" && other) return known(dot(v.value, other->value));
  if (name == "Cross" && other) return vectorDatum(cross(v.value, other->value));
  if (name == "Lerp" && other && a.size() > 1)
    if (const auto* t = a[1].as<double>())
      return vectorDatum(v.value + (other->value - v.value) * float(*t));
  return {};
}

Datum ofFrame(const Frame& f, const std::string& name, const std::vector<Datum>& a) {
  const Mat3& r = f.pose.rotation;
  if (name == "Position" || name == "p") return {Vector{f.pose.position, f.from}};
  if (name == "X" || name == "x") return known(f.pose.position.x);
  if (name == "Y" || name == "y") return known(f.pose.position.y);
  if (name == "Z" || name == "z") return known(f.pose.position.z);
  if (name == "LookVector" || name == "lookVector") return vectorDatum(-r.z);
  if (name == "RightVector" || name == "rightVector" || name == "XVector") return vectorDatum(r.x);
  if (name == "UpVector" || name == "upVector" || name == "YVector") return vectorDatum(r.y);
  if (name == "ZVector") return vectorDatum(r.z);
  if (name == "Rotation") return {Frame{{{}, r}, kNoInstance}};
  if (name == "Inverse" || name == "inverse") return {Frame{inverse(f.pose), kNoInstance}};
  if (a.empty()) return {};
  const auto* v = a[0].as<Vector>();
  const auto* other = a[0].as<Frame>();
  if (lower(name) == "vectortoworldspace" && v) return vectorDatum(r * v->value);
  if (lower(name) == "pointtoworldspace" && v) return vectorDatum(toWorld(f.pose, v->value));
  if (lower(name) == "toworldspace" && other) return {Frame{f.pose * other->pose, kNoInstance}};
  if (lower(name) == "toobjectspace" && other)
    return {Frame{inverse(f.pose) * other->pose, kNoInstance}};
  if (lower(name) == "lerp" && other && a.size() > 1)
    if (const auto* t = a[1].as<double>())
      return {Frame{between(f.pose, other->pose, float(*t)), kNoInstance}};
  return {};
}

Datum ofTiming(const TweenTiming& t, const std::string& name) {
  if (!t.known) return {};
  if (name == "Time") return {t.seconds};
  if (name == "DelayTime") return {t.delay};
  if (name == "RepeatCount") return {double(t.repeats)};
  if (name == "Reverses") return {t.reverses};
  return {};
}

bool isPlain(const std::string& pattern) {
  return pattern.find_first_of("^$()%.[]*+-?") == std::string::npos;
}

Datum ofText(const std::string& text, const std::string& name, const std::vector<Datum>& a) {
  if (name == "lower") return {lower(text)};
  if (name == "len") return {double(text.size())};
  const auto* pattern = a.empty() ? nullptr : a[0].as<std::string>();
  const bool anchored = pattern && a.size() == 1 && pattern->rfind('^', 0) == 0;
  const std::string plain = pattern ? pattern->substr(anchored ? 1 : 0) : std::string();
  if ((name == "find" || name == "match") && pattern && isPlain(plain)) {
    const size_t at = anchored && text.rfind(plain, 0) != 0 ? std::string::npos : text.find(plain);
    if (at == std::string::npos) return {Nil{}};
    return name == "find" ? Datum{double(at + 1)} : Datum{plain};
  }
  if (name == "match" && pattern && *pattern == "%d+") {
    const auto number = firstNumber(text);
    return number ? Datum{std::to_string(*number)} : Datum{Nil{}};
  }
  if (name == "sub" && !a.empty()) {
    const auto* from = a[0].as<double>();
    const auto* to = a.size() > 1 ? a[1].as<double>() : nullptr;
    if (!from || (a.size() > 1 && !to)) return {};
    const auto size = double(text.size());
    const double first = std::max(1.0, *from < 0 ? size + *from + 1 : *from);
    const double last = std::min(size, !to ? size : *to < 0 ? size + *to + 1 : *to);
    if (last < first) return {std::string()};
    return {text.substr(size_t(first) - 1, size_t(last - first) + 1)};
  }
  return {};
}

}  // namespace

Datum valueMethod(const Datum& object, const std::string& name, const std::vector<Datum>& a) {
  if (const auto* v = object.as<Vector>()) return ofVector(*v, name, a);
  if (const auto* f = object.as<Frame>()) return ofFrame(*f, name, a);
  if (const auto* timing = object.as<TweenTiming>()) return ofTiming(*timing, name);
  if (const auto* text = object.as<std::string>()) return ofText(*text, name, a);
  return {};
}

}  // namespace obby::importer::luau
