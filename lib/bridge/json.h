// The little JSON that the bridge itself speaks: objects written member by member, and members read
// from a tree. Records are lib/io's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/json_tree.h"

namespace obby::bridge {

// `{"a":1,"b":"x"}`, members in the order of the calls.
class JsonObject {
 public:
  JsonObject& text(std::string_view name, std::string_view value);
  JsonObject& number(std::string_view name, uint64_t value);
  JsonObject& real(std::string_view name, double value);  // finite
  JsonObject& truth(std::string_view name, bool value);
  JsonObject& json(std::string_view name, std::string_view value);  // a JSON value as it is
  // The members without braces, and the whole.
  const std::string& members() const { return out_; }
  std::string whole() const { return "{" + out_ + "}"; }

 private:
  void name(std::string_view name);
  std::string out_;
};

// `["a","b"]` of JSON values.
std::string jsonArray(const std::vector<std::string>& values);

// A value of a tree as JSON text again; numbers keep their spelling. Nesting is that of the tree,
// at most 64.
std::string jsonText(const io::JsonTree& tree, const io::JsonTree::Node& node);

// Calls `member` with the name and value of each member. Errors: `node` is no object, or names one
// twice; `[]` is the empty object, as Luau writes it.
using Member = std::function<Status(std::string_view name, const io::JsonTree::Node& value)>;
Status forMembers(const io::JsonTree& tree, const io::JsonTree::Node& node, const std::string& path,
                  const Member& member);

// Calls `element` with each element of an array and its index.
using Element = std::function<Status(uint32_t index, const io::JsonTree::Node& value)>;
Status forElements(const io::JsonTree& tree, const io::JsonTree::Node& node,
                   const std::string& path, const Element& element);

// The text of a node. Error: it is none.
Result<std::string> jsonString(const io::JsonTree& tree, const io::JsonTree::Node& node,
                               const std::string& path);

// "options.speed: unknown (did you mean ...)"
Error unknownMember(const std::string& path, std::string_view name,
                    const std::vector<std::string>& known);

inline Error pathError(const std::string& path, std::string message, std::string hint = {}) {
  return Error{{}, {}, path, std::move(message), std::move(hint)};
}

}  // namespace obby::bridge
