// Formats texts of the option table as sentences, and breaks them into lines of a given width.
#pragma once

#include <cstddef>
#include <string>

namespace obby::cli {

// Breaks `text` at blanks and after bars (a|b|c) into lines of at most `width` columns, if its
// words allow it. The first line begins at column `at`; every other is indented by `indent`.
std::string wrapped(const std::string& text, size_t at, size_t indent, size_t width);

// Returns `text` with a capital and a full stop.
std::string sentence(std::string text);

// Wraps each line of `text` by itself, and adds a newline after it.
std::string wrappedLines(const std::string& text, size_t indent, size_t width);

// Breaks a shell command after `|` and `&&` if it is wider than `width`: "a && \", "    b".
std::string wrappedCommand(const std::string& command, size_t indent, size_t width);

}  // namespace obby::cli
