// A Document as lines of text, for comparing two of them and for reading the difference.
#pragma once

#include <string>
#include <vector>

#include "engine/document.h"

namespace obby::test {

// One line an instance ("/Workspace:Workspace[0]/Part:Lava[0]": class, name, which of the equal
// siblings), followed by one line for each property, attribute and tag. Refs are written as the
// path of their target.
std::vector<std::string> linesOf(const Document& document);

// Lines of one that the other lacks, at most `limit`, as "only in first: ..."; empty if they are
// equal.
std::string difference(const Document& first, const Document& second, size_t limit = 20);

}  // namespace obby::test
