// Texts of the option table as sentences, and broken into lines of a given width.
#pragma once

#include <cstddef>
#include <string>

namespace obby::cli {

// `text` broken at blanks and behind bars (a|b|c) into lines of at most `width` columns where its
// words allow it. The first line begins at column `at`; every other is indented by `indent`.
std::string wrapped(const std::string& text, size_t at, size_t indent, size_t width);

// `text` with a capital and a full stop.
std::string sentence(std::string text);

// Each line of `text` wrapped by itself, with a newline behind it.
std::string wrappedLines(const std::string& text, size_t indent, size_t width);

// A shell command, broken behind `|` and `&&` where it is wider than `width`: "a && \", "    b".
std::string wrappedCommand(const std::string& command, size_t indent, size_t width);

}  // namespace obby::cli
