#include "io/json_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/schema_plan.h"
#include "io/text.h"

namespace obby::io {
namespace {

constexpr size_t kMaxValues = size_t(32) << 20;

// Returns "column 5", or "line 2 column 5" after the first of several lines. `count` is the number
// of characters up to the place, including it.
std::string placeAt(std::string_view text, size_t count) {
  const std::string_view before = text.substr(0, count == 0 ? 0 : count - 1);
  const size_t feed = before.rfind('\n');
  if (feed == std::string_view::npos) return fmt::format("column {}", count);
  const auto feeds = std::count(before.begin(), before.end(), '\n');
  return fmt::format("line {} column {}", feeds + 1, count - 1 - feed);
}

constexpr std::string_view kUnexpected = "unexpected ", kExpected = "; expected ";

// Returns plain words for the parser's name of a token.
std::string plain(std::string_view token) {
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {
      {"string literal", "a string in double quotes"},
      {"number literal", "a number"},
      {"invalid literal", "text that is not JSON"},
      {"end of input", "the end of the text"},
  };
  for (const auto& [name, words] : kNames)
    if (token == name) return std::string(words);
  return std::string(token);
}

// Returns what the parser expected, according to its message.
std::string expectedBy(std::string_view message) {
  const size_t at = message.rfind(kExpected);
  if (at == std::string_view::npos) return "JSON";
  const std::string_view token = message.substr(at + kExpected.size());
  const bool closes = token == "'}'" || token == "']'";  // otherwise another element must follow
  return (closes ? "',' or " : "") + plain(token);
}

}  // namespace

// The parser calls this. Returning false stops it.
class JsonTreeBuilder {
 public:
  explicit JsonTreeBuilder(JsonTree& tree, std::string_view source)
      : tree_(tree), source_(source) {}

  std::string message;

  bool null() { return add(JsonTree::Type::null, 0); }
  bool boolean(bool value) { return add(value ? JsonTree::Type::yes : JsonTree::Type::no, 0); }
  bool number_integer(int64_t value) { return add(JsonTree::Type::negative, uint64_t(value)); }
  bool number_unsigned(uint64_t value) { return add(JsonTree::Type::whole, value); }
  bool number_float(double, const std::string& text) { return addText(JsonTree::Type::real, text); }
  bool string(std::string& text) { return addText(JsonTree::Type::text, text); }
  bool binary(nlohmann::json::binary_t&) { return false; }  // JSON has none

  bool key(std::string& text) {
    name_ = uint32_t(tree_.texts_.size());
    nameLength_ = uint32_t(text.size());
    tree_.texts_ += text;
    return true;
  }
  bool start_object(size_t) { return open(JsonTree::Type::object); }
  bool start_array(size_t) { return open(JsonTree::Type::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool parse_error(size_t column, const std::string&, const nlohmann::detail::exception& e) {
    message = fmt::format("{}: {}", placeAt(source_, column), explain(column, e.what()));
    return false;
  }

 private:
  struct Open {
    uint32_t node;
    uint32_t last;  // last element so far of the open array or object; 0 for none
  };

  bool add(JsonTree::Type type, uint64_t value, uint32_t length = 0) {
    if (tree_.nodes_.size() >= kMaxValues) {
      message = fmt::format("expected at most {} million values, found more", kMaxValues >> 20);
      return false;
    }
    const uint32_t index = uint32_t(tree_.nodes_.size());
    JsonTree::Node node;
    node.type = type;
    node.value = value;
    node.length = length;
    node.name = name_;
    node.nameLength = nameLength_;
    nameLength_ = 0;
    tree_.nodes_.push_back(node);
    if (!open_.empty()) link(index);
    return true;
  }

  void link(uint32_t index) {
    Open& parent = open_.back();
    (parent.last ? tree_.nodes_[parent.last].next : tree_.nodes_[parent.node].child) = index;
    parent.last = index;
    tree_.nodes_[parent.node].length++;
  }

  bool addText(JsonTree::Type type, const std::string& text) {
    const size_t offset = tree_.texts_.size();
    tree_.texts_ += text;
    return add(type, offset, uint32_t(text.size()));
  }

  bool open(JsonTree::Type type) {
    if (open_.size() >= size_t(kMaxNesting)) {
      message = fmt::format("values are nested deeper than {} levels", kMaxNesting);
      return false;
    }
    if (!add(type, 0)) return false;
    open_.push_back({uint32_t(tree_.nodes_.size() - 1), 0});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  // Converts the parser's "syntax error while parsing PLACE - unexpected FOUND; last read: ...;
  // expected TOKEN" to our form.
  std::string explain(size_t column, std::string_view what) const {
    const bool inText = what.find("invalid string") != std::string_view::npos;
    for (const char* word : {"NaN", "-nan", "nan", "-Infinity", "Infinity", "-inf", "inf"}) {
      // The parser stops at the first or the second letter, or at a sign before the word.
      const size_t at = source_.find(word, column < 2 ? 0 : column - 2);
      if (at <= column && !inText) return fmt::format("expected a finite number, found {}", word);
    }
    if (column > source_.size()) return std::string(JsonTree::kCutOff);
    if (what.find("number overflow") != std::string_view::npos) return "the number is too large";
    if (const size_t dash = what.find(" - "); dash != std::string_view::npos)
      what.remove_prefix(dash + 3);
    std::string_view found = what.substr(0, what.find(';'));
    if (found.starts_with(kUnexpected)) found.remove_prefix(kUnexpected.size());
    return fmt::format("expected {}, found {}", expectedBy(what), plain(found));
  }

  JsonTree& tree_;
  std::string_view source_;
  std::vector<Open> open_;
  uint32_t name_ = 0, nameLength_ = 0;
};

Result<JsonTree> JsonTree::parse(std::string_view text) {
  // The parser treats a zero byte as the end of the text, and would ignore what follows it.
  if (const size_t zero = text.find('\0'); zero != std::string_view::npos) {
    return makeError(placeAt(text, zero + 1) + ": expected JSON, found a zero byte");
  }
  JsonTree tree;
  JsonTreeBuilder builder(tree, text);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) {
    if (builder.message.empty()) builder.message = "the text is not JSON";
    return makeError(builder.message);
  }
  return tree;
}

const JsonTree::Node* JsonTree::find(const Node& object, std::string_view name) const {
  if (object.type != Type::object) return nullptr;
  for (const Node& member : children(object)) {
    if (this->name(member) == name) return &member;
  }
  return nullptr;
}

std::string JsonTree::describe(const Node& n) const {
  switch (n.type) {
    case Type::null: return "null";
    case Type::no: return "false";
    case Type::yes: return "true";
    case Type::negative: return fmt::format("{}", int64_t(n.value));
    case Type::whole: return fmt::format("{}", n.value);
    case Type::real: return std::string(text(n).substr(0, 40));
    case Type::text: return "text " + quoted(text(n));
    case Type::array: return fmt::format("an array of {}", n.length);
    case Type::object: break;
  }
  return n.length == 0 ? "an empty object" : "an object";
}

}  // namespace obby::io
