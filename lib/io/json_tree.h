// One JSON value in flat arrays. Numbers keep their text, so that each is converted once, to the
// type of its field. Text beyond the limits of nesting and of the number of values is an error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace obby::io {

class JsonTree {
 public:
  enum class Type : uint8_t { null, no, yes, negative, whole, real, text, array, object };

  struct Node {
    // Whole: the value; negative: bits of int64_t; text, real: offset in texts.
    uint64_t value = 0;
    uint32_t length = 0;  // text, real: bytes; array, object: elements
    uint32_t child = 0;   // array, object: the first element
    uint32_t next = 0;    // the element after this one; 0 for none
    uint32_t name = 0;    // member of an object: offset in texts
    uint32_t nameLength = 0;
    Type type = Type::null;
  };

  // The elements of an array or object, in order: for (const Node& member : tree.children(node)).
  class Children {
   public:
    class Iterator {
     public:
      Iterator(const JsonTree& tree, uint32_t at) : tree_(tree), at_(at) {}
      const Node& operator*() const { return tree_.node(at_); }
      Iterator& operator++() {
        at_ = tree_.node(at_).next;
        return *this;
      }
      bool operator==(const Iterator& other) const { return at_ == other.at_; }

     private:
      const JsonTree& tree_;
      uint32_t at_;
    };

    Children(const JsonTree& tree, uint32_t first) : tree_(tree), first_(first) {}
    Iterator begin() const { return {tree_, first_}; }
    Iterator end() const { return {tree_, 0}; }

   private:
    const JsonTree& tree_;
    uint32_t first_;
  };

  // Errors have only a message: the column and what is wrong there.
  static Result<JsonTree> parse(std::string_view text);
  // A message about an incomplete value ends with this text.
  static constexpr std::string_view kCutOff = "the text ends in the middle of a value";

  const Node& root() const { return nodes_[0]; }
  const Node& node(uint32_t index) const { return nodes_[index]; }
  Children children(const Node& n) const { return {*this, n.child}; }
  // Returns the first member of an object with that name, or null.
  const Node* find(const Node& object, std::string_view name) const;
  std::string_view text(const Node& n) const {
    return std::string_view(texts_).substr(n.value, n.length);
  }
  std::string_view name(const Node& n) const {
    return std::string_view(texts_).substr(n.name, n.nameLength);
  }

  // Returns `text "abc"`, `an array of 2` or `1.5`, for errors.
  std::string describe(const Node& n) const;

 private:
  friend class JsonTreeBuilder;
  std::vector<Node> nodes_;
  std::string texts_;
};

}  // namespace obby::io
