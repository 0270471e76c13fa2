// Splits names at changes of case and kind of character.
#include "import/document/words.h"

namespace obby::importer {
namespace {

enum class Kind { lower, upper, digit, other };

Kind kindOf(char c) {
  if (c >= 'a' && c <= 'z') return Kind::lower;
  if (c >= 'A' && c <= 'Z') return Kind::upper;
  if (c >= '0' && c <= '9') return Kind::digit;
  return static_cast<unsigned char>(c) >= 0x80 ? Kind::lower : Kind::other;
}

}  // namespace

std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  Kind last = Kind::other;
  for (size_t i = 0; i < name.size(); ++i) {
    const Kind kind = kindOf(name[i]);
    const bool nextLower = i + 1 < name.size() && kindOf(name[i + 1]) == Kind::lower;
    const bool continues = kind == last || (last == Kind::upper && kind == Kind::lower);
    const bool newCapital = kind == Kind::upper && last == Kind::upper && nextLower;
    if (kind != Kind::other) {
      if (!continues || newCapital || words.empty()) words.emplace_back();
      words.back() += kind == Kind::upper ? char(name[i] - 'A' + 'a') : name[i];
    }
    last = kind;
  }
  return words;
}

}  // namespace obby::importer
