#include "bridge/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/spelling.h"
#include "io/text.h"
#include "io/utf8.h"

namespace obby::bridge {
namespace {

using io::JsonTree;
using Node = JsonTree::Node;
using Type = JsonTree::Type;

void append(std::string& out, const JsonTree& tree, const Node& node) {
  switch (node.type) {
    case Type::null: out += "null"; return;
    case Type::no: out += "false"; return;
    case Type::yes: out += "true"; return;
    case Type::negative: out += fmt::format("{}", int64_t(node.value)); return;
    case Type::whole: out += fmt::format("{}", node.value); return;
    case Type::real: out += tree.text(node); return;
    case Type::text: io::appendJsonString(out, tree.text(node)); return;
    case Type::array:
    case Type::object: break;
  }
  const bool object = node.type == Type::object;
  out += object ? '{' : '[';
  for (uint32_t i = node.child; i != 0; i = tree.node(i).next) {
    if (i != node.child) out += ',';
    if (object) {
      io::appendJsonString(out, tree.name(tree.node(i)));
      out += ':';
    }
    append(out, tree, tree.node(i));
  }
  out += object ? '}' : ']';
}

}  // namespace

void JsonObject::name(std::string_view name) {
  if (!out_.empty()) out_ += ',';
  io::appendJsonString(out_, name);
  out_ += ':';
}

JsonObject& JsonObject::text(std::string_view name, std::string_view value) {
  this->name(name);
  io::appendJsonString(out_, io::isUtf8(value) ? value : io::validUtf8(value));
  return *this;
}

JsonObject& JsonObject::number(std::string_view name, uint64_t value) {
  return json(name, fmt::format("{}", value));
}

JsonObject& JsonObject::real(std::string_view name, double value) {
  return json(name, std::isfinite(value) ? fmt::format("{}", value) : "null");
}

JsonObject& JsonObject::truth(std::string_view name, bool value) {
  return json(name, value ? "true" : "false");
}

JsonObject& JsonObject::json(std::string_view name, std::string_view value) {
  this->name(name);
  out_ += value;
  return *this;
}

std::string jsonArray(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ","));
}

std::string jsonText(const JsonTree& tree, const Node& node) {
  std::string out;
  append(out, tree, node);
  return out;
}

Status forMembers(const JsonTree& tree, const Node& node, const std::string& path,
                  const Member& member) {
  const bool empty = node.type == Type::array && node.length == 0;
  if (node.type != Type::object && !empty) {
    return pathError(path, "expected an object, found " + tree.describe(node));
  }
  std::vector<std::string_view> seen;
  for (uint32_t i = node.child; i != 0; i = tree.node(i).next) {
    const std::string_view name = tree.name(tree.node(i));
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
      return pathError(path, "given twice: " + io::quoted(name));
    }
    if (seen.size() >= 64) return pathError(path, "more than 64 members");
    seen.push_back(name);
    if (tree.node(i).type == Type::null) continue;
    OBBY_RETURN_IF_ERROR(member(name, tree.node(i)));
  }
  return {};
}

Status forElements(const JsonTree& tree, const Node& node, const std::string& path,
                   const Element& element) {
  if (node.type != Type::array) {
    return pathError(path, "expected an array, found " + tree.describe(node));
  }
  uint32_t index = 0;
  for (uint32_t i = node.child; i != 0; i = tree.node(i).next) {
    OBBY_RETURN_IF_ERROR(element(index++, tree.node(i)));
  }
  return {};
}

Result<std::string> jsonString(const JsonTree& tree, const Node& node, const std::string& path) {
  if (node.type != Type::text) {
    return pathError(path, "expected a string, found " + tree.describe(node));
  }
  return std::string(tree.text(node));
}

Error unknownMember(const std::string& path, std::string_view name,
                    const std::vector<std::string>& known) {
  const std::string near = nearestName(name, known);
  const std::string where = path.empty() ? io::quoted(name) : path + "." + io::quoted(name);
  return pathError(where, "unknown",
                   near.empty() ? fmt::format("expected one of {}", fmt::join(known, ", "))
                                : "did you mean " + near + "?");
}

}  // namespace obby::bridge
