// The table of level styles, one row each. A new style is a file in styles/ and a row in
// styles.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "gen/style.h"

namespace obby::gen {

const std::vector<Style>& styles();

// Returns null for an unknown name.
const Style* findStyle(std::string_view name);

// Returns the style in a generated level's name (Generated::name), or null if there is none.
const Style* styleOfLevel(std::string_view levelName);

// These return the style or parameter with this name. Error at `path`: an unknown name. The hint
// lists similar names.
Result<const Style*> styleNamed(std::string_view name, const std::string& path);
Result<const Parameter*> parameterNamed(const Style& style, std::string_view name,
                                        const std::string& path);

// Returns a name such as "gaps.size". The parameter belongs to a style of the table.
std::string fullName(const Parameter& parameter);

}  // namespace obby::gen
