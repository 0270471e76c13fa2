#include "bridge/moving.h"

#include <algorithm>

#include "bridge/json.h"

namespace obby::bridge {
namespace {

using io::JsonTree;

bool moves(const JsonTree& tree, const JsonTree::Node& part) {
  if (part.type != JsonTree::Type::object) return false;
  for (const JsonTree::Node& member : tree.children(part)) {
    const std::string_view name = tree.name(member);
    const bool given = member.type != JsonTree::Type::null;
    if (given && (name == "motion" || name == "vanish")) return true;
    if (name == "anchored" && member.type == JsonTree::Type::no) return true;
  }
  return false;
}

void writeMoving(io::JsonWriter& out, const JsonTree& tree, const JsonTree::Node& list) {
  out.open('[');
  for (const JsonTree::Node& part : tree.children(list)) {
    if (moves(tree, part)) {
      writeNode(out, tree, part);
    } else {
      out.raw("{}");
    }
  }
  out.close();
}

std::string recordOf(const JsonTree& tree) {
  io::JsonWriter out;
  out.open('{');
  for (const JsonTree::Node& member : tree.children(tree.root())) {
    out.key(tree.name(member));
    if (tree.name(member) == "parts" && member.type == JsonTree::Type::array) {
      writeMoving(out, tree, member);
    } else {
      writeNode(out, tree, member);
    }
  }
  return out.finish();
}

}  // namespace

Result<std::string> movingParts(std::string_view lines) {
  std::string out;
  for (size_t at = 0; at < lines.size();) {
    const size_t end = std::min(lines.find('\n', at), lines.size());
    OBBY_ASSIGN(const JsonTree tree, JsonTree::parse(lines.substr(at, end - at)));
    out.append(recordOf(tree)).append("\n");
    at = end + 1;
  }
  return out;
}

}  // namespace obby::bridge
