// Splits names into lower-case words: "KillBrick 2" is kill, brick, 2.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace obby::importer {

std::vector<std::string> wordsOf(std::string_view name);

// Returns the first word of `name`, or pair of adjacent words, that is in `list`, or nothing.
// "CheckPoint" contains checkpoint, "Skill" does not contain kill.
template <class List>
std::string firstWordIn(std::string_view name, const List& list) {
  const auto words = wordsOf(name);
  const auto isIn = [&](const std::string& word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
  };
  for (size_t i = 0; i < words.size(); ++i) {
    if (isIn(words[i])) return words[i];
    const std::string pair = i + 1 < words.size() ? words[i] + words[i + 1] : std::string();
    if (isIn(pair)) return pair;
  }
  return {};
}

// Returns true if `text` contains any entry of `list`, in the same case.
template <class List>
bool hasAny(std::string_view text, const List& list) {
  return std::any_of(std::begin(list), std::end(list), [&](std::string_view one) {
    return text.find(one) != std::string_view::npos;
  });
}

}  // namespace obby::importer
