// Writes floats so that equal text means equal bits, except that all NaNs have the same text.
#include "support/document_text.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <map>

namespace obby::test {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value == 0 ? 0.0 : value);
  return value != value ? "nan" : text;
}

std::string vector(Vec3 v) {
  return "(" + number(v.x) + " " + number(v.y) + " " + number(v.z) + ")";
}

std::string bytes(const std::string& text) {
  std::string out = "'";
  for (const char c : text.substr(0, 60)) {
    char hex[8];
    std::snprintf(hex, sizeof hex, "\\x%02x", static_cast<unsigned char>(c));
    out += c >= ' ' && c <= '~' ? std::string(1, c) : std::string(hex);
  }
  return out + "' " + std::to_string(text.size()) + " bytes " +
         std::to_string(std::hash<std::string>{}(text));
}

struct ValueText {
  const std::vector<std::string>& paths;

  std::string operator()(std::monostate) const { return "unread"; }
  std::string operator()(bool v) const { return v ? "true" : "false"; }
  std::string operator()(int64_t v) const { return "int " + std::to_string(v); }
  std::string operator()(double v) const { return number(v); }
  std::string operator()(const std::string& v) const { return bytes(v); }
  std::string operator()(const EnumItem& v) const {
    return "enum " + v.type + ":" + std::to_string(v.value);
  }
  std::string operator()(Vec3 v) const { return vector(v); }
  std::string operator()(const CFrame& v) const {
    return vector(v.position) + " x" + vector(v.rotation.x) + " y" + vector(v.rotation.y) + " z" +
           vector(v.rotation.z);
  }
  std::string operator()(ColorRgb v) const {
    return "rgb " + std::to_string(v.r) + " " + std::to_string(v.g) + " " + std::to_string(v.b);
  }
  std::string operator()(Ref v) const {
    return "ref " + (v.target == kNoInstance ? "none" : paths.at(v.target));
  }
  std::string operator()(const PhysicalProperties& v) const {
    if (!v.custom) return "physics default";
    return "physics " + number(v.density) + " " + number(v.friction) + " " + number(v.elasticity) +
           " " + number(v.frictionWeight) + " " + number(v.elasticityWeight);
  }
  std::string operator()(UDim v) const {
    return "udim " + number(v.scale) + " " + std::to_string(v.offset);
  }
  std::string operator()(NumberRange v) const {
    return "range " + number(v.min) + " " + number(v.max);
  }
  std::string operator()(const SharedBlob& v) const { return "shared " + bytes(*v.bytes); }
};

// Returns the paths of all instances. A step of a path is the class, the name, and an index among
// siblings with the same class and name. Therefore an additional instance does not change the paths
// of others.
std::vector<std::string> pathsOf(const Document& document) {
  std::vector<std::string> paths(document.instances.size());
  const auto placeAll = [&](const std::vector<InstanceId>& siblings, const std::string& parent) {
    std::map<std::string, int> seen;
    for (const InstanceId id : siblings) {
      const Instance& instance = document.instances[id];
      const std::string step = parent + "/" + instance.className + ":" + instance.name;
      paths[id] = step + "[" + std::to_string(seen[step]++) + "]";
    }
  };
  placeAll(document.roots, "");
  for (InstanceId id = 0; id < document.instances.size(); ++id) {
    placeAll(document.instances[id].children, paths[id]);
  }
  return paths;
}

void onlyIn(const char* label, const std::vector<std::string>& a, const std::vector<std::string>& b,
            size_t limit, std::string& out) {
  std::vector<std::string> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  for (size_t i = 0; i < std::min(rest.size(), limit); ++i) out += label + rest[i] + "\n";
  if (rest.size() > limit) out += label + std::to_string(rest.size() - limit) + " more lines\n";
}

}  // namespace

std::vector<std::string> linesOf(const Document& document) {
  const std::vector<std::string> paths = pathsOf(document);
  const ValueText text{paths};
  std::vector<std::string> lines;
  for (InstanceId id = 0; id < document.instances.size(); ++id) {
    const Instance& instance = document.instances[id];
    const std::string& path = paths[id];
    lines.push_back(path);
    for (const auto& [name, value] : instance.properties) {
      lines.push_back(path + "." + name + " = " + std::visit(text, value));
    }
    for (const auto& [name, value] : instance.attributes) {
      lines.push_back(path + "@" + name + " = " + std::visit(text, value));
    }
    for (const std::string& tag : instance.tags) lines.push_back(path + "#" + tag);
  }
  return lines;
}

std::string difference(const Document& first, const Document& second, size_t limit) {
  std::vector<std::string> a = linesOf(first), b = linesOf(second);
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::string out;
  onlyIn("only in first:  ", a, b, limit, out);
  onlyIn("only in second: ", b, a, limit, out);
  return out;
}

}  // namespace obby::test
