// Pure functions of known values: constructors, math, strings. A call with unknown arguments is
// unknown, but vectors keep the components that are known.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "import/luau/reader.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr Vec3 kNoAxis = {kNoNumber, kNoNumber, kNoNumber};

double numberAt(const std::vector<Datum>& a, size_t i, double absent) {
  if (i >= a.size()) return absent;
  const auto* n = a[i].as<double>();
  return n ? *n : double(kNoNumber);
}

Datum frame(const Pose& p) { return {Frame{p, kNoInstance}}; }

Mat3 turned(int axis, double angle) {
  return rotationAbout(axis == 0   ? Vec3{1, 0, 0}
                       : axis == 1 ? Vec3{0, 1, 0}
                                   : Vec3{0, 0, 1},
                       angle);
}

bool allKnown(const std::vector<Datum>& a, size_t count) {
  for (size_t i = 0; i < count; ++i)
    if (i < a.size() && !a[i].as<double>()) return false;
  return true;
}

Datum angles(const std::vector<Datum>& a, bool yxz) {
  if (!allKnown(a, 3)) return {};
  const Mat3 x = turned(0, numberAt(a, 0, 0)), y = turned(1, numberAt(a, 1, 0)),
             z = turned(2, numberAt(a, 2, 0));
  return frame({{}, yxz ? y * x * z : x * y * z});
}

Datum lookAt(Vec3 from, Vec3 to) {
  const Vec3 back = normalize(from - to, {0, 0, 1});
  const Vec3 right = normalize(cross({0, 1, 0}, back), {1, 0, 0});
  return frame({from, {right, cross(back, right), back}});
}

Datum newFrame(const std::vector<Datum>& a) {
  if (a.empty()) return frame({});
  if (const auto* position = a[0].as<Vector>()) {
    if (a.size() == 1) return frame({position->value, {}});
    if (const auto* to = a[1].as<Vector>()) return lookAt(position->value, to->value);
    return frame({position->value, {kNoAxis, kNoAxis, kNoAxis}});  // looks at what is not known
  }
  if (!allKnown(a, a.size()) || (a.size() > 3 && a.size() != 7 && a.size() != 12)) return {};
  Pose pose;
  pose.position = {float(numberAt(a, 0, 0)), float(numberAt(a, 1, 0)), float(numberAt(a, 2, 0))};
  const auto at = [&](size_t i) { return float(numberAt(a, i, 0)); };
  if (a.size() == 7) pose.rotation = toMat3(normalize(Quat{at(3), at(4), at(5), at(6)}));
  if (a.size() == 12)
    pose.rotation = {{at(3), at(6), at(9)}, {at(4), at(7), at(10)}, {at(5), at(8), at(11)}};
  return frame(pose);
}

Datum newTweenInfo(const std::vector<Datum>& a) {
  constexpr double kLongest = 1e6;      // seconds: longer than a motion can take, and so named
  constexpr double kMostRepeats = 1e5;  // for longer than a motion can take
  TweenTiming t;
  const auto number = [&](size_t i, double absent) {
    const double v = numberAt(a, i, absent);
    t.known = t.known && (!std::isnan(v) || a[i].as<Nil>());
    return std::isnan(v) ? absent : v;
  };
  t.seconds = std::clamp(number(0, 1), 0.0, kLongest);
  t.repeats = int(std::clamp(number(3, 0), -1.0, kMostRepeats));
  t.delay = std::clamp(number(5, 0), 0.0, kLongest);
  if (a.size() > 4)
    if (const auto* flag = a[4].as<bool>()) t.reverses = *flag;
  const auto last = [&](size_t i) -> std::string {
    const auto* item = i < a.size() ? a[i].as<Library>() : nullptr;
    return item ? lower(item->name.substr(item->name.rfind('.') + 1)) : "";
  };
  static constexpr std::string_view kStyles[] = {"linear",      "sine",     "back",   "quad",
                                                 "quart",       "quint",    "bounce", "elastic",
                                                 "exponential", "circular", "cubic"};
  for (size_t i = 0; i < std::size(kStyles); ++i)
    if (last(1) == kStyles[i]) t.easing = Easing(i);
  const std::string direction = last(2);
  if (direction == "in") t.direction = EasingDirection::in;
  if (direction == "inout") t.direction = EasingDirection::inOut;
  return {t};
}

using Function1 = double (*)(double);
struct MathRow {
  const char* name;
  Function1 function;
};
const MathRow kMath[] = {{"math.sin", [](double v) { return std::sin(v); }},
                         {"math.cos", [](double v) { return std::cos(v); }},
                         {"math.tan", [](double v) { return std::tan(v); }},
                         {"math.rad", [](double v) { return v * kPi / 180; }},
                         {"math.deg", [](double v) { return v * 180 / kPi; }},
                         {"math.abs", [](double v) { return std::abs(v); }},
                         {"math.floor", [](double v) { return std::floor(v); }},
                         {"math.ceil", [](double v) { return std::ceil(v); }},
                         {"math.round", [](double v) { return std::round(v); }},
                         {"math.sqrt", [](double v) { return std::sqrt(v); }},
                         {"math.exp", [](double v) { return std::exp(v); }}};

// `math.max(0, h.Health - 20)`, `math.clamp(h.Health - 20, 0, 100)`: what comes off is the same, as
// is what comes on: `math.min(h.Health + 20, h.MaxHealth)`.
std::optional<Datum> boundedChange(const std::vector<Datum>& a, bool most) {
  constexpr double kFull = 100;  // health
  if (a.size() < 2) return std::nullopt;
  const size_t at = a[0].as<Change>() ? 0 : 1;
  const auto* change = a[at].as<Change>();
  const auto* bound = a[1 - at].as<double>();
  if (!change) return std::nullopt;
  const bool same = most ? isAllHealth(a[1 - at]) || (bound && *bound >= kFull)
                         : bound && (*bound <= 0 || change->by >= 0);
  return same ? std::optional<Datum>(a[at]) : std::nullopt;
}

Datum mathCall(const std::string& path, const std::vector<Datum>& a) {
  const auto* first = a.empty() ? nullptr : a[0].as<double>();
  for (const auto& row : kMath)
    if (path == row.name) return first ? Datum{row.function(*first)} : Datum{};
  if (path == "math.max" || path == "math.min" || path == "math.clamp")
    if (auto change = boundedChange(a, path == "math.min")) return *change;
  if (!allKnown(a, a.size()) || a.size() < 2) return {};
  const double x = *first, y = numberAt(a, 1, 0);
  if (path == "math.max" || path == "math.min") {
    double most = x;
    for (size_t i = 1; i < a.size(); ++i) {
      const double next = numberAt(a, i, 0);
      most = path == "math.max" ? std::max(most, next) : std::min(most, next);
    }
    return {most};
  }
  if (path == "math.clamp" && a.size() == 3) return {std::max(y, std::min(x, numberAt(a, 2, y)))};
  if (path == "math.pow") return {std::pow(x, y)};
  if (path == "math.fmod" && y != 0) return {std::fmod(x, y)};
  return {};
}

Datum converted(const Datum& value) {
  if (value.as<double>()) return value;
  const auto* text = value.as<std::string>();
  const auto number = text ? numberFrom(obby::Value(*text)) : std::nullopt;
  return number ? Datum{*number} : Datum{};
}

}  // namespace

Datum vectorDatum(Vec3 v) { return {Vector{v, kNoInstance}}; }

Datum libraryField(const std::string& path) {
  if (path == "math.pi") return {kPi};
  if (path == "math.huge") return {std::numeric_limits<double>::infinity()};
  if (path == "Vector3.zero") return vectorDatum({});
  if (path == "Vector3.one") return vectorDatum({1, 1, 1});
  if (path == "Vector3.xAxis") return vectorDatum({1, 0, 0});
  if (path == "Vector3.yAxis") return vectorDatum({0, 1, 0});
  if (path == "Vector3.zAxis") return vectorDatum({0, 0, 1});
  if (path == "CFrame.identity") return frame({});
  return {Library{path}};
}

Datum libraryCall(const std::string& path, const std::vector<Datum>& a) {
  if (path == "Vector3.new" || path == "vector.create")
    return vectorDatum(
        {float(numberAt(a, 0, 0)), float(numberAt(a, 1, 0)), float(numberAt(a, 2, 0))});
  if (path == "CFrame.new") return newFrame(a);
  if ((path == "typeof" || path == "type") && a.size() == 1 && a[0].as<Ref>())
    return {std::string(path == "type" ? "userdata" : "Instance")};
  if (path == "CFrame.Angles" || path == "CFrame.fromEulerAnglesXYZ" ||
      path == "CFrame.fromEulerAngles" || path == "CFrame.angles")
    return angles(a, false);
  if (path == "CFrame.fromEulerAnglesYXZ" || path == "CFrame.fromOrientation")
    return angles(a, true);
  if (path == "CFrame.fromAxisAngle" && a.size() == 2) {
    const auto* axis = a[0].as<Vector>();
    const auto* angle = a[1].as<double>();
    if (axis && angle) return frame({{}, rotationAbout(normalize(axis->value), *angle)});
    return {};
  }
  if (path == "CFrame.lookAt" && a.size() >= 2) {
    const auto *from = a[0].as<Vector>(), *to = a[1].as<Vector>();
    return from && to ? lookAt(from->value, to->value) : Datum{};
  }
  if (path == "BrickColor.new" && a.size() == 1) return colorGiven(a[0]);
  if (path == "Color3.new") return colorMade(a, 1);
  if (path == "Color3.fromRGB") return colorMade(a, 255);
  if (path == "TweenInfo.new") return newTweenInfo(a);
  if (path == "tonumber" && !a.empty()) return converted(a[0]);
  if (path == "tostring" && !a.empty()) return arithmetic("..", a[0], {std::string()});
  if (path.rfind("math.", 0) == 0) return mathCall(path, a);
  if (path.rfind("string.", 0) == 0 && !a.empty())
    return valueMethod(a[0], path.substr(7), {a.begin() + 1, a.end()});
  return {};
}

}  // namespace obby::importer::luau
