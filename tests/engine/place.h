// A small place for tests of the script twin.
#pragma once

#include <string>
#include <utility>

#include "engine/document.h"
#include "engine/stage.h"

namespace obby::test {

class Place {
 public:
  Place() {
    workspace = add("Workspace", "Workspace", kNoInstance);
    scripts = add("ServerScriptService", "ServerScriptService", kNoInstance);
    const InstanceId spawn = part("Spawn", {0, 0.5f, 0}, "SpawnLocation");
    set(spawn, "Size", Vec3{6, 1, 6});
  }

  InstanceId add(const std::string& className, const std::string& name, InstanceId parent) {
    Instance instance;
    instance.className = className;
    instance.name = name;
    instance.parent = parent;
    const auto id = InstanceId(document.instances.size());
    document.instances.push_back(std::move(instance));
    (parent == kNoInstance ? document.roots : document.instances[parent].children).push_back(id);
    return id;
  }
  InstanceId part(const std::string& name, Vec3 position, const std::string& className = "Part") {
    const InstanceId id = add(className, name, workspace);
    set(id, "Anchored", true);
    set(id, "CFrame", CFrame{position, {}});
    set(id, "Size", Vec3{4, 1, 4});
    return id;
  }
  InstanceId script(const std::string& source, InstanceId parent,
                    const std::string& className = "Script") {
    const InstanceId id = add(className, className, parent);
    set(id, "Source", source);
    return id;
  }
  void set(InstanceId id, const std::string& name, Value value) {
    document.instances[id].properties[name] = std::move(value);
  }

  Document document;
  InstanceId workspace, scripts;
};

// Returns the problems of scripts, one on each line.
inline std::string problems(const engine::Observation& seen) {
  std::string all;
  for (const engine::Problem& problem : seen.problems) all += problem.text + "\n";
  return all;
}

// Runs `text` as a server script for half a second, and returns the final value of its variable
// `result`. The script raises the value as an error, which the stage keeps as a problem.
inline std::string resultOf(const std::string& text) {
  Place place;
  place.script(text + "\nerror('result ' .. tostring(result), 0)", place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(30);
  const std::string all = problems(stage.observation());
  const size_t begin = all.find("result ");
  return begin == std::string::npos ? all : all.substr(begin + 7, all.size() - begin - 8);
}

}  // namespace obby::test
