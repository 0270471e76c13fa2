#include "import/rojo/json_file.h"

#include <fmt/format.h>

#include <charconv>

#include "io/text.h"

namespace obby::importer::rojo {
namespace {

// Returns the offset after the closing quote of a text that begins with a quote.
size_t endOfText(std::string_view text, size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

// Returns the end of a comment, or `at` if none begins there.
size_t endOfComment(std::string_view text, size_t at) {
  if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
  if (text.substr(at, 2) != "/*") return at;
  const size_t close = text.find("*/", at + 2);
  return close == std::string_view::npos ? text.size() : close + 2;
}

// Converts to strict JSON and keeps every byte's position.
std::string strict(std::string_view text) {
  std::string out(text);
  size_t comma = std::string::npos;  // position of a comma after a value, followed only by blanks
  char last = '{';
  for (size_t at = 0; at < text.size();) {
    const size_t end = endOfComment(text, at);
    for (size_t i = at; i < end; ++i)
      if (out[i] != '\n') out[i] = ' ';
    if (end > at) {
      at = end;
      continue;
    }
    const char c = text[at];
    if ((c == '}' || c == ']') && comma != std::string::npos) out[comma] = ' ';
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
      const bool isBehindValue = last != '{' && last != '[' && last != ',' && last != ':';
      comma = c == ',' && isBehindValue ? at : std::string::npos;
      last = c;
    }
    at = c == '"' ? endOfText(text, at) : at + 1;
  }
  return out;
}

void appendQuoted(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || byte < ' ' || byte == 127)
      out += fmt::format("\\{:03}", byte);
    else
      out += c;
  }
  out += '"';
}

void appendLuau(std::string& out, const Json& value) {
  if (const auto text = value.text()) return appendQuoted(out, *text);
  if (value.isObject() || value.isArray()) {
    out += '{';
    for (const auto& [name, element] : value.members()) {
      if (value.isObject()) {
        out += '[';
        appendQuoted(out, name);
        out += "] = ";
      }
      appendLuau(out, element);
      out += ", ";
    }
    out += '}';
    return;
  }
  const auto number = value.number();
  out += number         ? fmt::format("{}", *number)
         : value.flag() ? (*value.flag() ? "true" : "false")
                        : "nil";
}

}  // namespace

std::optional<bool> Json::flag() const {
  if (!node_ || (type() != Type::yes && type() != Type::no)) return {};
  return type() == Type::yes;
}

std::optional<double> Json::number() const {
  if (!node_) return {};
  if (type() == Type::whole) return double(node_->value);
  if (type() == Type::negative) return double(int64_t(node_->value));
  if (type() != Type::real) return {};
  const std::string_view digits = tree_->text(*node_);
  double value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

std::optional<std::string> Json::text() const {
  if (!isText()) return {};
  return std::string(tree_->text(*node_));
}

std::optional<std::vector<double>> Json::numbers() const {
  if (!isArray()) return {};
  std::vector<double> out;
  for (const auto& [name, element] : members()) {
    const auto number = element.number();
    if (!number) return {};
    out.push_back(*number);
  }
  return out;
}

Json Json::operator[](std::string_view name) const {
  if (!isObject()) return {};
  for (uint32_t at = node_->child; at != 0; at = tree_->node(at).next) {
    const auto& node = tree_->node(at);
    if (tree_->name(node) == name) return node.type == Type::null ? Json() : Json(*tree_, node);
  }
  return {};
}

std::vector<std::pair<std::string, Json>> Json::members() const {
  std::vector<std::pair<std::string, Json>> out;
  if (!isObject() && !isArray()) return out;
  for (uint32_t at = node_->child; at != 0; at = tree_->node(at).next) {
    const auto& node = tree_->node(at);
    out.emplace_back(tree_->name(node), Json(*tree_, node));
  }
  return out;
}

Result<io::JsonTree> parseJson(std::string_view text) {
  return io::JsonTree::parse(strict(io::withoutByteOrderMark(text)));
}

std::string luauOf(const Json& value) {
  std::string out = "return ";
  appendLuau(out, value);
  return out + "\n";
}

std::string luauOf(std::string_view text) {
  std::string out = "return ";
  appendQuoted(out, text);
  return out + "\n";
}

}  // namespace obby::importer::rojo
