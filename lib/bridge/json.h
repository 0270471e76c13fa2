// The bridge's own JSON: objects that are written member by member, and members that are read from
// a tree. lib/io handles records.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/json_tree.h"

namespace obby::bridge {

// Writes `{"a":1,"b":"x"}`, with members in the order of the calls.
class JsonObject {
 public:
  JsonObject& text(std::string_view name, std::string_view value);
  JsonObject& number(std::string_view name, uint64_t value);
  JsonObject& real(std::string_view name, double value);  // null if not finite
  JsonObject& truth(std::string_view name, bool value);
  JsonObject& json(std::string_view name, std::string_view value);  // a JSON value, unchanged
  // Return the members without braces, and the whole object.
  const std::string& members() const { return out_; }
  std::string whole() const { return "{" + out_ + "}"; }

 private:
  void name(std::string_view name);
  std::string out_;
};

// Returns `["a","b"]` for JSON values.
std::string jsonArray(const std::vector<std::string>& values);

// Returns a value of a tree as JSON text. Numbers keep their spelling. Nesting is that of the tree,
// at most 64.
std::string jsonText(const io::JsonTree& tree, const io::JsonTree::Node& node);

// Calls `member` with the name and value of each member that is not null. It is an error if `node`
// is not an object, or names a member twice. `[]` is the empty object, as Luau writes it.
using Member = std::function<Status(std::string_view name, const io::JsonTree::Node& value)>;
Status forMembers(const io::JsonTree& tree, const io::JsonTree::Node& node, const std::string& path,
                  const Member& member);

// Calls `element` with each element of an array and its index.
using Element = std::function<Status(uint32_t index, const io::JsonTree::Node& value)>;
Status forElements(const io::JsonTree& tree, const io::JsonTree::Node& node,
                   const std::string& path, const Element& element);

// Returns the text of a node. A node of another type is an error.
Result<std::string> jsonString(const io::JsonTree& tree, const io::JsonTree::Node& node,
                               const std::string& path);

// Returns "options.speed: unknown (did you mean ...)".
Error unknownMember(const std::string& path, std::string_view name,
                    const std::vector<std::string>& known);

inline Error pathError(const std::string& path, std::string message, std::string hint = {}) {
  return Error{{}, {}, path, std::move(message), std::move(hint)};
}

}  // namespace obby::bridge
