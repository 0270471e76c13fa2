// The table of level styles: one row each. A new style is a file in styles/ and a row in
// styles.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "gen/style.h"

namespace obby::gen {

const std::vector<Style>& styles();

// Null if there is none of that name.
const Style* findStyle(std::string_view name);

// The style that a generated level's name says, as of Generated::name; null: it says none.
const Style* styleOfLevel(std::string_view levelName);

// `path`: where the name stands, for the error that there is none of that name, which names what
// is near.
Result<const Style*> styleNamed(std::string_view name, const std::string& path);
Result<const Parameter*> parameterNamed(const Style& style, std::string_view name,
                                        const std::string& path);

// "gaps.size"; the parameter is one of a style of the table.
std::string fullName(const Parameter& parameter);

}  // namespace obby::gen
