// Reads the engine's classes, their members and the items of its enums from api/classes.txt.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace obby::engine {

class ClassTable {
 public:
  // Reads the table at the first call.
  static const ClassTable& get();

  // Returns the base class, empty for the root, or null if there is no such class.
  const std::string_view* baseOf(std::string_view className) const;
  // Returns the member's code, inherited ones included: ":", ".", "!" for a method, event,
  // callback, else the property's type (classes.txt). Returns "" if the class has no such member.
  std::string_view member(std::string_view className, std::string_view name) const;
  // Returns "Plastic=256 Neon=288 ...", or "" if there is no such enum.
  std::string_view enumItems(std::string_view name) const;

 private:
  ClassTable();
  struct Class {
    std::string_view base;
    std::unordered_map<std::string_view, std::string_view> members;
  };

  void addLine(std::string_view line, Class*& open);

  std::unordered_map<std::string_view, Class> classes_;
  std::unordered_map<std::string_view, std::string_view> enums_;
};

}  // namespace obby::engine
