// A Document as lines of text, for comparing two documents and showing the difference.
#pragma once

#include <string>
#include <vector>

#include "engine/document.h"

namespace obby::test {

// Returns one line per instance ("/Workspace:Workspace[0]/Part:Lava[0]": class, name, index among
// equal siblings). One line for each property, attribute and tag follows. Refs are written as the
// path of their target.
std::vector<std::string> linesOf(const Document& document);

// Returns at most `limit` lines that only one of the documents has, in the form "only in first:
// ...". Returns an empty string if the documents are equal.
std::string difference(const Document& first, const Document& second, size_t limit = 20);

}  // namespace obby::test
