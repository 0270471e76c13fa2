// Matches the globIgnorePaths of a Rojo project.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby::importer::rojo {

// Returns true if the glob matches. `*` and `?` match anything but a slash, `**` matches anything.
// `path` has slashes.
bool matchesGlob(std::string_view glob, std::string_view path);

// Returns true if the last matching pattern ignores the path. A pattern that begins with `!`
// includes it again.
bool isIgnored(const std::vector<std::string>& globs, std::string_view path);

}  // namespace obby::importer::rojo
