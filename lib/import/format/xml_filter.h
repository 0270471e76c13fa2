// Makes old XML places fit for an XML parser: they hold character references that XML forbids.
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
// characters stay: the parser takes them. Comments and CDATA are not looked into.
FilteredXml filterXml(std::string_view source);

// Where in the source the byte at `offset` of the filtered text comes from.
size_t sourceOffset(std::string_view source, size_t offset);

}  // namespace obby::importer
