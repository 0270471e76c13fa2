// What a Rojo project says by names: the kinds of files, and the classes of nodes.
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
  std::string stem;  // the name without the ending
};

// By the end of the name.
FileName fileNameOf(std::string_view name);

// Whether a file makes an instance of its folder; those that come first go before the others.
inline constexpr std::string_view kInitFiles[] = {
    "init.luau",        "init.lua",         "init.server.luau",
    "init.server.lua",  "init.client.luau", "init.client.lua",
    "init.plugin.luau", "init.plugin.lua",  "init.csv"};

// Whether a file says what its folder is.
bool isOfFolder(std::string_view name);

// The class that a node has by its name and its parent's class; empty: none.
std::string inferredClass(const std::string& name, std::string_view parentClass);

}  // namespace obby::importer::rojo
