// A tool's output without its times, which are the only difference between runs.
#pragma once

#include <string>

namespace obby::solve {

inline std::string withoutTiming(std::string text) {
  for (size_t at; (at = text.find(",\"timing\":{")) != std::string::npos;) {
    text.erase(at, text.find('}', at) + 1 - at);
  }
  return text;
}

}  // namespace obby::solve
