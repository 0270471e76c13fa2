#include "engine/classes/class_table.h"

#include "engine/embedded.h"

namespace obby::engine {
namespace {

// The text before and after the first space.
struct Halves {
  std::string_view first, rest;
};
Halves split(std::string_view text) {
  const size_t space = text.find(' ');
  if (space == std::string_view::npos) return {text, {}};
  return {text.substr(0, space), text.substr(space + 1)};
}

}  // namespace

const ClassTable& ClassTable::get() {
  static const ClassTable kTable;
  return kTable;
}

ClassTable::ClassTable() {
  std::string_view text = embeddedFile("classes.txt");
  Class* open = nullptr;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    addLine(text.substr(0, end), open);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

void ClassTable::addLine(std::string_view line, Class*& open) {
  if (line.empty()) return;
  if (line[0] != ' ') {
    const auto [first, rest] = split(line);
    if (first == "enum") {
      const auto [name, items] = split(rest);
      enums_[name] = items;
    } else {
      open = &classes_[first];
      open->base = rest == "-" ? std::string_view{} : rest;
    }
    return;
  }
  line.remove_prefix(1);
  if (line[0] == ':' || line[0] == '.' || line[0] == '!')
    open->members[line.substr(1)] = line.substr(0, 1);
  else if (const auto [name, code] = split(line); open)
    open->members[name] = code;
}

const std::string_view* ClassTable::baseOf(std::string_view className) const {
  const auto found = classes_.find(className);
  return found == classes_.end() ? nullptr : &found->second.base;
}

std::string_view ClassTable::member(std::string_view className, std::string_view name) const {
  auto found = classes_.find(className);
  while (found != classes_.end()) {
    const auto row = found->second.members.find(name);
    if (row != found->second.members.end()) return row->second;
    found = classes_.find(found->second.base);
  }
  return {};
}

std::string_view ClassTable::enumItems(std::string_view name) const {
  const auto found = enums_.find(name);
  return found == enums_.end() ? std::string_view{} : found->second;
}

}  // namespace obby::engine
