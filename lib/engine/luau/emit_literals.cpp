// Emits numbers and strings.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/luau/expression_emitter.h"

namespace obby::luau {

void ExpressionEmitter::number(double value) {
  if (std::isinf(value)) return out_.word("1e999");
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  out_.word({text, size_t(result.ptr - text)});
}

// Writes escapes with three digits: shorter ones would merge with digits after them.
void ExpressionEmitter::string(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (byte >= ' ' && byte <= '~') {
      text += c;
    } else {
      text += '\\';
      for (const int unit : {100, 10, 1}) text += char('0' + byte / unit % 10);
    }
  }
  out_.symbol(text + '"');
}

void ExpressionEmitter::interpolation(const Expr& expr) {
  std::vector<const Expr*> parts;
  for (size_t i = 0; i < expr.keys.size(); ++i) {
    if (!expr.keys[i]->text.empty()) parts.push_back(expr.keys[i].get());
    if (i < expr.kids.size()) parts.push_back(expr.kids[i].get());
  }
  const size_t groups = (parts.size() + kMaxArguments - 1) / kMaxArguments;
  if (groups > 1) helper("interp");
  for (size_t i = 0; i < parts.size(); i += kMaxArguments) {
    if (i > 0) out_.symbol(",");
    interpolation(parts, i);
  }
  if (groups > 1) out_.symbol(")");
}

// Emits one group of parts.
void ExpressionEmitter::interpolation(const std::vector<const Expr*>& parts, size_t from) {
  helper("interp");
  for (size_t i = from; i < std::min(parts.size(), from + kMaxArguments); ++i) {
    if (i > from) out_.symbol(",");
    single(*parts[i]);
  }
  out_.symbol(")");
}

}  // namespace obby::luau
