// Names as people write them, split into lower-case words: "KillBrick 2" is kill, brick, 2.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby::importer {

std::vector<std::string> wordsOf(std::string_view name);

// The first word of `name` that is in `list`, or nothing: "Skill" does not contain kill.
template <class List>
std::string firstWordIn(std::string_view name, const List& list) {
  for (const auto& word : wordsOf(name))
    for (std::string_view entry : list)
      if (word == entry) return word;
  return {};
}

}  // namespace obby::importer
