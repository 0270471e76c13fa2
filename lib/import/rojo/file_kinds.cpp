#include "import/rojo/file_kinds.h"

#include <algorithm>
#include <iterator>

namespace obby::importer::rojo {
namespace {

struct Ending {
  std::string_view text;
  FileKind kind;
};
// Extensions; the first match counts.
constexpr Ending kEndings[] = {{".project.json", FileKind::project},
                               {".project.jsonc", FileKind::project},
                               {".model.json", FileKind::modelJson},
                               {".model.jsonc", FileKind::modelJson},
                               {".meta.json", FileKind::meta},
                               {".meta.jsonc", FileKind::meta},
                               {".server.lua", FileKind::serverScript},
                               {".server.luau", FileKind::serverScript},
                               {".client.lua", FileKind::clientScript},
                               {".client.luau", FileKind::clientScript},
                               {".plugin.lua", FileKind::pluginScript},
                               {".plugin.luau", FileKind::pluginScript},
                               {".lua", FileKind::moduleScript},
                               {".luau", FileKind::moduleScript},
                               {".json", FileKind::json},
                               {".jsonc", FileKind::json},
                               {".toml", FileKind::data},
                               {".yml", FileKind::data},
                               {".yaml", FileKind::data},
                               {".txt", FileKind::text},
                               {".csv", FileKind::table},
                               {".rbxm", FileKind::model},
                               {".rbxmx", FileKind::model}};

constexpr std::string_view kProjectServices[] = {"Chat",
                                                 "Lighting",
                                                 "Players",
                                                 "ReplicatedFirst",
                                                 "ReplicatedStorage",
                                                 "ServerStorage",
                                                 "StarterGui",
                                                 "StarterPack",
                                                 "StarterPlayer",
                                                 "Teams",
                                                 "Workspace",
                                                 "ServerScriptService",
                                                 "SoundService"};

}  // namespace

FileName fileNameOf(std::string_view name) {
  for (const Ending& ending : kEndings)
    if (name.ends_with(ending.text) && name.size() > ending.text.size())
      return {ending.kind, std::string(name.substr(0, name.size() - ending.text.size()))};
  return {};
}

bool isOfFolder(std::string_view name) {
  return std::find(std::begin(kInitFiles), std::end(kInitFiles), name) != std::end(kInitFiles) ||
         name == "init.meta.json" || name == "init.meta.jsonc";
}

std::string inferredClass(const std::string& name, std::string_view parentClass) {
  const bool isService = std::find(std::begin(kProjectServices), std::end(kProjectServices),
                                   name) != std::end(kProjectServices) ||
                         name.ends_with("Service");
  if (parentClass == "DataModel") return isService ? name : "";
  if (parentClass == "Workspace" && name == "Terrain") return name;
  const bool isContainer = name == "StarterPlayerScripts" || name == "StarterCharacterScripts";
  return parentClass == "StarterPlayer" && isContainer ? name : "";
}

}  // namespace obby::importer::rojo
