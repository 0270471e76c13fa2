// globIgnorePaths of a Rojo project.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby::importer::rojo {

// `*` and `?` stand for what is no slash, `**` for anything; `path` has slashes.
bool matchesGlob(std::string_view glob, std::string_view path);

// Of the patterns that match the last one counts; one that begins with `!` takes back.
bool isIgnored(const std::vector<std::string>& globs, std::string_view path);

}  // namespace obby::importer::rojo
