// What a file of a Rojo project becomes, by the end of its name.
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

FileName fileNameOf(std::string_view name);

// Whether a file makes an instance of its folder; those that come first go before the others.
inline constexpr std::string_view kInitFiles[] = {
    "init.luau",        "init.lua",         "init.server.luau",
    "init.server.lua",  "init.client.luau", "init.client.lua",
    "init.plugin.luau", "init.plugin.lua",  "init.csv"};

}  // namespace obby::importer::rojo
