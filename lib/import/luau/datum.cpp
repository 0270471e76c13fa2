// Arithmetic and comparison over partly known values.
#include "import/luau/datum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

#include "import/luau/values.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

double applied(char op, double a, double b) {
  switch (op) {
    case '+': return a + b;
    case '-': return a - b;
    case '*': return a * b;
    case '/': return a / b;
    case '%': return b == 0 ? std::nan("") : a - std::floor(a / b) * b;
    case '^': return std::pow(a, b);
    default: return std::nan("");
  }
}

Datum number(double value) {
  if (std::isnan(value)) return {};
  return {value};
}

// Vector op vector or number.
Datum vectors(char op, const Datum& a, const Datum& b) {
  const auto* va = a.as<Vector>();
  const auto* vb = b.as<Vector>();
  const auto* na = a.as<double>();
  const auto* nb = b.as<double>();
  if (!(va || na) || !(vb || nb)) return {};
  if ((op == '+' || op == '-') && !(va && vb)) return {};
  Vec3 out;
  float* to[3] = {&out.x, &out.y, &out.z};
  for (int i = 0; i < 3; ++i)
    *to[i] =
        float(applied(op, va ? component(va->value, i) : *na, vb ? component(vb->value, i) : *nb));
  return {Vector{out, kNoInstance}};
}

Datum frames(char op, const Frame& a, const Datum& b) {
  if (const auto* fb = b.as<Frame>(); fb && op == '*') {
    const bool onTheSpot = length(fb->pose.position) < 1e-6f;
    return {Frame{a.pose * fb->pose, kNoInstance, onTheSpot ? a.at : kNoInstance, a.statement}};
  }
  const auto* vb = b.as<Vector>();
  if (!vb) return {};
  if (op == '*') return {Vector{toWorld(a.pose, vb->value), kNoInstance}};
  Frame moved{a.pose, kNoInstance};
  if (op == '+')
    moved.pose.position += vb->value;
  else if (op == '-')
    moved.pose.position -= vb->value;
  else
    return {};
  return {moved};
}

// A stranger's number changed by what the script states: Health - 30, Velocity + Vector3.new(...).
Datum strangers(char op, const Stranger& a, const Datum& b) {
  const auto* nb = b.as<double>();
  if (nb && (op == '+' || op == '-')) return {Change{a.name, op == '+' ? *nb : -*nb}};
  if (nb && op == '*' && *nb == 0) return {0.0};
  const bool share = nb && ((op == '*' && *nb < 1) || (op == '/' && *nb > 1));
  if (share && isAllHealth({a})) return {};
  const bool untold = b.as<Unknown>() && a.name == "Health";
  if (op == '-' && isAllHealth(b))
    return {Change{a.name, -std::numeric_limits<double>::infinity()}};
  if (op == '-' && (untold || b.as<Stranger>())) return {Change{a.name, std::nan("")}};
  if (untold) return {};
  if (const auto* vb = b.as<Vector>(); vb && op == '+') {
    const auto keep = [](float v) { return v == 0 ? kNaN : v; };
    return {Vector{{keep(vb->value.x), keep(vb->value.y), keep(vb->value.z)}, kNoInstance}};
  }
  return {a};
}

// What every script finds; what else a name may mean, other code has to say.
constexpr std::string_view kGlobals[] = {
    "game",         "Game",       "workspace",    "Workspace",      "script",
    "shared",       "_G",         "_VERSION",     "Enum",           "math",
    "string",       "table",      "task",         "coroutine",      "os",
    "debug",        "bit32",      "utf8",         "buffer",         "vector",
    "Instance",     "Vector3",    "Vector2",      "Vector3int16",   "CFrame",
    "Color3",       "BrickColor", "UDim",         "UDim2",          "Ray",
    "Rect",         "Region3",    "TweenInfo",    "Random",         "DateTime",
    "NumberRange",  "Faces",      "Axes",         "NumberSequence", "PathWaypoint",
    "wait",         "Wait",       "spawn",        "Spawn",          "delay",
    "Delay",        "print",      "warn",         "error",          "assert",
    "pcall",        "xpcall",     "pairs",        "ipairs",         "next",
    "select",       "unpack",     "type",         "typeof",         "tostring",
    "tonumber",     "require",    "tick",         "time",           "elapsedTime",
    "setmetatable", "rawget",     "rawset",       "rawequal",       "rawlen",
    "getmetatable", "newproxy",   "loadstring",   "getfenv",        "setfenv",
    "version",      "settings",   "UserSettings", "gcinfo",         "PhysicalProperties"};

bool isUnknownName(const Datum& datum) {
  const auto* library = datum.as<Library>();
  if (!library) return false;
  const std::string_view name = library->name;
  const std::string_view first = name.substr(0, name.find('.'));
  return std::find(std::begin(kGlobals), std::end(kGlobals), first) == std::end(kGlobals);
}

}  // namespace

const Datum& argument(const std::vector<Datum>& arguments, size_t i) {
  static const Datum kNone;
  return i < arguments.size() ? arguments[i] : kNone;
}

Scope* Scope::holder(const std::string& name) {
  for (Scope* scope = this; scope; scope = scope->parent)
    if (scope->names.count(name)) return scope;
  return nullptr;
}

Truth truthOf(const Datum& datum) {
  if (datum.as<Unknown>() || datum.as<Stranger>() || datum.as<Change>()) return Truth::unknown;
  if (isUnknownName(datum)) return Truth::unknown;
  if (datum.as<Nil>()) return Truth::no;
  if (const auto* flag = datum.as<bool>()) return *flag ? Truth::yes : Truth::no;
  return Truth::yes;
}

Truth negated(Truth truth) {
  return truth == Truth::unknown ? truth : truth == Truth::yes ? Truth::no : Truth::yes;
}

Datum datumOf(Truth truth) {
  if (truth == Truth::unknown) return {};
  return {truth == Truth::yes};
}

Datum datumFrom(const obby::Value& value, InstanceId owner) {
  if (const auto* flag = std::get_if<bool>(&value)) return {*flag};
  if (const auto* whole = std::get_if<int64_t>(&value)) return {double(*whole)};
  if (const auto* real = std::get_if<double>(&value)) return {*real};
  if (const auto* text = std::get_if<std::string>(&value)) return {*text};
  if (const auto* vector = std::get_if<Vec3>(&value)) return {Vector{*vector, owner}};
  if (const auto* frame = std::get_if<CFrame>(&value)) return {Frame{*frame, owner}};
  if (const auto* ref = std::get_if<Ref>(&value)) {
    if (ref->target == kNoInstance) return {Nil{}};
    return {*ref};
  }
  return {};
}

bool isAllHealth(const Datum& datum) {
  const auto* stranger = datum.as<Stranger>();
  return stranger && (stranger->name == "Health" || stranger->name == "MaxHealth");
}

Datum oneOf(const Datum& a, const Datum& b) {
  if (a.as<Stranger>()) return a;
  if (b.as<Stranger>()) return b;
  const auto *tableA = a.as<Table*>(), *tableB = b.as<Table*>();
  if (tableA && tableB && *tableA == *tableB) return a;
  return truthOf(compared("==", a, b)) == Truth::yes ? a : Datum{};
}

Datum arithmetic(const std::string& op, const Datum& a, const Datum& b) {
  const auto asText = [](const Datum& d) -> std::optional<std::string> {
    if (const auto* text = d.as<std::string>()) return *text;
    const auto* n = d.as<double>();
    if (!n) return std::nullopt;
    return *n == std::floor(*n) && std::abs(*n) < 1e15 ? std::to_string(int64_t(*n))
                                                       : fmt::format("{}", *n);
  };
  if (op == "..") {
    const auto left = asText(a), right = asText(b);
    constexpr size_t kLongest = 10000;
    if (!left || !right || left->size() + right->size() > kLongest) return {};
    return {*left + *right};
  }
  if (op == "//") {
    const auto *na = a.as<double>(), *nb = b.as<double>();
    return na && nb ? number(std::floor(*na / *nb)) : Datum{};
  }
  const char sign = op[0];
  if (const auto* frame = a.as<Frame>()) return frames(sign, *frame, b);
  if (const auto* stranger = a.as<Stranger>()) return strangers(sign, *stranger, b);
  const auto *na = a.as<double>(), *nb = b.as<double>();
  if (na && nb) return number(applied(sign, *na, *nb));
  if (a.as<Vector>() || b.as<Vector>()) return vectors(sign, a, b);
  return {};
}

Datum compared(const std::string& op, const Datum& a, const Datum& b) {
  const bool differs = op == "~=";
  if (op == "==" || differs) {
    bool same = false;
    if (a.as<Unknown>() || b.as<Unknown>() || a.as<Stranger>() || b.as<Stranger>()) return {};
    if (isUnknownName(a) || isUnknownName(b)) return {};
    const bool color = isColor(a) || isColor(b);
    if (color && (a.as<double>() || b.as<double>())) return {};  // files keep some as numbers
    if (a.value.index() != b.value.index()) {
      same = false;
    } else if (const auto* n = a.as<double>()) {
      same = *n == *b.as<double>();
    } else if (const auto* text = a.as<std::string>()) {
      same = *text == *b.as<std::string>();
    } else if (const auto* flag = a.as<bool>()) {
      same = *flag == *b.as<bool>();
    } else if (const auto* ref = a.as<Ref>()) {
      same = ref->target == b.as<Ref>()->target;
    } else if (const auto* item = a.as<Library>()) {
      same = item->name == b.as<Library>()->name;
    } else if (a.as<Nil>()) {
      same = true;
    } else {
      return {};
    }
    return {same != differs};
  }
  const auto *na = a.as<double>(), *nb = b.as<double>();
  if (!na || !nb) return {};
  if (op == "<") return {*na < *nb};
  if (op == ">") return {*na > *nb};
  if (op == "<=") return {*na <= *nb};
  return {*na >= *nb};
}

}  // namespace obby::importer::luau
