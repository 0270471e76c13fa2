#include "cli/wrap.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace obby::cli {
namespace {

constexpr size_t kContinued = 4;     // columns by which a command's second line is indented
constexpr size_t kContinuation = 2;  // columns of " \"

// Returns the stages of a pipeline or list, each except the last with the operator after it.
std::vector<std::string> stages(const std::string& command) {
  std::vector<std::string> out;
  size_t begin = 0;
  for (size_t i = 0; i < command.size(); i++) {
    for (const std::string_view sign : {" | ", " && "}) {
      if (std::string_view(command).substr(i, sign.size()) != sign) continue;
      i += sign.size();
      out.push_back(command.substr(begin, i - 1 - begin));
      begin = i;
    }
  }
  out.push_back(command.substr(begin));
  return out;
}

}  // namespace

std::string sentence(std::string text) {
  if (text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text + ".";
}

std::string wrapped(const std::string& text, size_t at, size_t indent, size_t width) {
  std::string out;
  size_t column = at;
  bool blank = false;  // a blank is due before the next piece
  for (size_t i = 0; i < text.size();) {
    const size_t end = std::min(text.find_first_of(" |", i), text.size());
    const bool bar = end < text.size() && text[end] == '|';
    const size_t length = end - i + (bar ? 1 : 0);
    if (column > indent && column + (blank ? 1 : 0) + length > width) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (blank) {
      out += ' ';
      column++;
    }
    out.append(text, i, length);
    column += length;
    blank = !bar;
    i = end + 1;
  }
  return out;
}

std::string wrappedLines(const std::string& text, size_t indent, size_t width) {
  std::string out;
  for (size_t i = 0; i <= text.size();) {
    const size_t end = std::min(text.find('\n', i), text.size());
    const std::string line = text.substr(i, end - i);
    if (!line.empty()) out += std::string(indent, ' ') + wrapped(line, indent, indent, width);
    out += '\n';
    i = end + 1;
  }
  return out;
}

std::string wrappedCommand(const std::string& command, size_t indent, size_t width) {
  if (indent + command.size() <= width) return command;
  std::string out;
  size_t column = indent;
  for (const std::string& stage : stages(command)) {
    if (!out.empty() && column + 1 + stage.size() + kContinuation > width) {
      out += " \\\n" + std::string(indent + kContinued, ' ');
      column = indent + kContinued;
    } else if (!out.empty()) {
      out += ' ';
      column++;
    }
    out += stage;
    column += stage.size();
  }
  return out;
}

}  // namespace obby::cli
