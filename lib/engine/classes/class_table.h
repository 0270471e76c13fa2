// The engine's classes, their members and the items of its enums, from api/classes.txt.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace obby::engine {

class ClassTable {
 public:
  // Reads the table at the first call.
  static const ClassTable& get();

  // The base class, empty for the root; null: there is no such class.
  const std::string_view* baseOf(std::string_view className) const;
  // The member's code, inherited ones included: ":", ".", "!" for a method, event, callback, else
  // the property's type (classes.txt). Empty: the class has none of that name.
  std::string_view member(std::string_view className, std::string_view name) const;
  // "Plastic=256 Neon=288 ..."; empty: there is no such enum.
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
