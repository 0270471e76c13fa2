// Prepares old XML places for an XML parser: they hold character references that XML forbids.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::importer {

struct FilteredXml {
  std::string text;
  size_t replaced = 0;  // references that stand for no character, now U+FFFD
};

// Replaces references to NUL, to surrogates and beyond Unicode. References to other control
// characters stay, since the parser accepts them. Comments and CDATA are left unchanged.
FilteredXml filterXml(std::string_view source);

// Returns the offset in the source of the byte at `offset` of the filtered text.
size_t sourceOffset(std::string_view source, size_t offset);

}  // namespace obby::importer
