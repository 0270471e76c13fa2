#include "cli/arguments.h"

#include <charconv>
#include <cstdlib>

namespace obby::cli {

const Arguments::Value& Arguments::at(const std::string& name) const {
  return values.at(name);  // a missing row is a bug in the tool's table
}

const std::string& Arguments::only(const std::string& name) const {
  static const std::string none;
  const Value& value = at(name);
  return value.texts.empty() ? none : value.texts.back();
}

bool Arguments::has(const std::string& name) const { return at(name).given; }
bool Arguments::flag(const std::string& name) const { return only(name) == "true"; }

bool Arguments::typed(const std::string& name) const {
  const Value& value = at(name);
  return value.typed && (value.row.type != ValueType::flag || flag(name));
}

const std::string& Arguments::text(const std::string& name) const { return only(name); }

int64_t Arguments::integer(const std::string& name) const {
  return std::strtoll(only(name).c_str(), nullptr, 10);
}

uint64_t Arguments::seed(const std::string& name) const {
  return std::strtoull(only(name).c_str(), nullptr, 10);
}

double Arguments::number(const std::string& name) const {
  const std::string& text = only(name);
  double out = 0;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

const std::vector<std::string>& Arguments::list(const std::string& name) const {
  return at(name).texts;
}

Status refuseTyped(const Arguments& arguments, std::initializer_list<const char*> names,
                   const std::string& message, const std::string& cure) {
  for (const char* name : names) {
    if (arguments.typed(name)) return Error{{}, {}, std::string("--") + name, message, cure};
  }
  return {};
}

}  // namespace obby::cli
