#include "bridge/json.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/spelling.h"
#include "io/text.h"

namespace obby::bridge {
namespace {

using io::JsonTree;
using Node = JsonTree::Node;
using Type = JsonTree::Type;

}  // namespace

void writeNode(io::JsonWriter& out, const JsonTree& tree, const Node& node) {
  switch (node.type) {
    case Type::null: out.null(); return;
    case Type::no: out.value(false); return;
    case Type::yes: out.value(true); return;
    case Type::negative: out.value(int64_t(node.value)); return;
    case Type::whole: out.value(node.value); return;
    case Type::real: out.raw(tree.text(node)); return;
    case Type::text: out.value(tree.text(node)); return;
    case Type::array:
    case Type::object: break;
  }
  const bool object = node.type == Type::object;
  out.open(object ? '{' : '[');
  for (const Node& each : tree.children(node)) {
    if (object) out.key(tree.name(each));
    writeNode(out, tree, each);
  }
  out.close();
}

std::string jsonText(const JsonTree& tree, const Node& node) {
  io::JsonWriter out;
  writeNode(out, tree, node);
  return out.finish();
}

Status forMembers(const JsonTree& tree, const Node& node, const std::string& path,
                  const Member& member) {
  const bool empty = node.type == Type::array && node.length == 0;
  if (node.type != Type::object && !empty) {
    return pathError(path, "expected an object, found " + tree.describe(node));
  }
  std::vector<std::string_view> seen;
  for (const Node& each : tree.children(node)) {
    const std::string_view name = tree.name(each);
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
      return pathError(path, "this field is given twice: " + io::quoted(name));
    }
    if (seen.size() >= 64) return pathError(path, "expected at most 64 fields, found more");
    seen.push_back(name);
    if (each.type == Type::null) continue;
    OBBY_RETURN_IF_ERROR(member(name, each));
  }
  return {};
}

Status forElements(const JsonTree& tree, const Node& node, const std::string& path,
                   const Element& element) {
  if (node.type != Type::array) {
    return pathError(path, "expected an array, found " + tree.describe(node));
  }
  uint32_t index = 0;
  for (const Node& each : tree.children(node)) OBBY_RETURN_IF_ERROR(element(index++, each));
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
  return pathError(where, "unknown field",
                   near.empty() ? fmt::format("expected one of {}", fmt::join(known, ", "))
                                : "did you mean " + near + "?");
}

}  // namespace obby::bridge
