#include "cli/roff.h"

namespace obby::cli::roff {
namespace {

std::string_view glyph(char c) {
  switch (c) {
    case '\\': return "\\e";
    case '-': return "\\-";
    case '\'': return "\\(aq";
    case '"': return "\\(dq";
    case '`': return "\\(ga";
    case '^': return "\\(ha";
    case '~': return "\\(ti";
    default: return {};
  }
}

std::string inFont(char font, std::string_view text) {
  return std::string("\\f") + font + escaped(text) + "\\fR";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  bool lineBegins = true;
  for (const char c : text) {
    if (lineBegins && c == '.') out += "\\&";
    const std::string_view special = glyph(c);
    out += special.empty() ? std::string_view(&c, 1) : special;
    lineBegins = c == '\n';
  }
  return out;
}

std::string argument(std::string_view text) { return '"' + escaped(text) + '"'; }
std::string bold(std::string_view text) { return inFont('B', text); }
std::string italic(std::string_view text) { return inFont('I', text); }

}  // namespace obby::cli::roff
