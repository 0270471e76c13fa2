// Parses the JSON of Rojo's files: comments and commas before a closing bracket are allowed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/json_tree.h"

namespace obby::importer::rojo {

// One value of a JsonTree. The tree must outlive it. A default-constructed value is absent.
class Json {
 public:
  using Type = io::JsonTree::Type;

  Json() = default;
  Json(const io::JsonTree& tree, const io::JsonTree::Node& node) : tree_(&tree), node_(&node) {}

  explicit operator bool() const { return node_ != nullptr; }
  Type type() const { return node_->type; }
  bool isObject() const { return node_ && node_->type == Type::object; }
  bool isArray() const { return node_ && node_->type == Type::array; }
  bool isText() const { return node_ && node_->type == Type::text; }
  size_t size() const { return node_->length; }
  std::string describe() const { return tree_->describe(*node_); }

  std::optional<bool> flag() const;
  std::optional<double> number() const;
  std::optional<std::string> text() const;
  // Returns the items of an array that contains only numbers.
  std::optional<std::vector<double>> numbers() const;

  // Returns the member of that name, or an absent value if there is none or it is null.
  Json operator[](std::string_view name) const;
  // Returns the members of an object with their names, or the items of an array without names.
  std::vector<std::pair<std::string, Json>> members() const;

 private:
  const io::JsonTree* tree_ = nullptr;
  const io::JsonTree::Node* node_ = nullptr;
};

// Parses the text. Errors name the column or line.
Result<io::JsonTree> parseJson(std::string_view text);

// Returns a Luau chunk that returns the value.
std::string luauOf(const Json& value);
// Returns a Luau chunk that returns the text.
std::string luauOf(std::string_view text);

}  // namespace obby::importer::rojo
