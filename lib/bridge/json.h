// Reads members of JSON trees, and copies their values. lib/io handles records.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/json_tree.h"
#include "io/json_writer.h"

namespace obby::bridge {

// Writes a value of a tree. Numbers keep their spelling. A tree is nested at most 64 deep.
void writeNode(io::JsonWriter& out, const io::JsonTree& tree, const io::JsonTree::Node& node);
// Returns the value as JSON text.
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

// Returns the error "options.speed: unknown field (did you mean ...)".
Error unknownMember(const std::string& path, std::string_view name,
                    const std::vector<std::string>& known);

inline Error pathError(const std::string& path, std::string message, std::string hint = {}) {
  return Error{{}, {}, path, std::move(message), std::move(hint)};
}

}  // namespace obby::bridge
