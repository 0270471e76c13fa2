// Reads meaning from the names in a Rojo project: the kinds of files, and the classes of nodes.
#pragma once

#include <string>
#include <string_view>

namespace obby::importer::rojo {

enum class FileKind {
  none,
  project,
  modelJson,
  meta,
  serverScript,
  clientScript,
  pluginScript,
  moduleScript,
  json,
  data,  // TOML and YAML
  text,
  table,  // CSV
  model   // rbxm, rbxmx
};

struct FileName {
  FileKind kind = FileKind::none;
  std::string stem;  // name without its extension
};

// Returns the kind of a file by the end of its name.
FileName fileNameOf(std::string_view name);

// Files that make an instance of their folder, in order of precedence.
inline constexpr std::string_view kInitFiles[] = {
    "init.luau",        "init.lua",         "init.server.luau",
    "init.server.lua",  "init.client.luau", "init.client.lua",
    "init.plugin.luau", "init.plugin.lua",  "init.csv"};

// Returns true if a file describes its folder.
bool isOfFolder(std::string_view name);

// Returns the class that a node gets from its name and its parent's class, or "" if none.
std::string inferredClass(const std::string& name, std::string_view parentClass);

}  // namespace obby::importer::rojo
