// A small place built by hand as a Document, and the level that the importer makes from it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engine/document.h"
#include "import/level/build_level.h"
#include "import/observed/run.h"

namespace obby::test {

using importer::LevelDraft;
using importer::PartDraft;

// Starts with Workspace (0) and ServerScriptService (1); `model()` starts empty.
class Scene {
 public:
  Scene() {
    document.file = "test.rbxl";
    document.format = "rbxl";
    workspace = add("Workspace", "Workspace", kNoInstance);
    scripts = add("ServerScriptService", "ServerScriptService", kNoInstance);
  }
  static Scene model() {
    Scene scene;
    scene.document = {};
    scene.document.file = "test.rbxm";
    scene.document.format = "rbxm";
    scene.workspace = kNoInstance;
    return scene;
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
  // Adds an anchored part of 4 x 1 x 4 studs.
  InstanceId part(const std::string& name, Vec3 position, InstanceId parent,
                  const std::string& className = "Part") {
    const InstanceId id = add(className, name, parent);
    set(id, "Anchored", true);
    set(id, "CFrame", CFrame{position, {}});
    set(id, "Size", Vec3{4, 1, 4});
    return id;
  }
  InstanceId part(const std::string& name, Vec3 position = {}) {
    return part(name, position, workspace);
  }
  InstanceId script(const std::string& source, InstanceId parent,
                    const std::string& name = "Script") {
    const InstanceId id = add("Script", name, parent);
    set(id, "Source", source);
    return id;
  }
  InstanceId value(const std::string& className, const std::string& name, Value value,
                   InstanceId parent) {
    const InstanceId id = add(className, name, parent);
    set(id, "Value", std::move(value));
    return id;
  }
  void set(InstanceId id, const std::string& property, Value value) {
    document.instances[id].properties[property] = std::move(value);
  }
  void attribute(InstanceId id, const std::string& name, Value value) {
    document.instances[id].attributes[name] = std::move(value);
  }
  void tag(InstanceId id, const std::string& tag) { document.instances[id].tags.push_back(tag); }

  const LevelDraft& level() {
    const importer::ObservedPlace place = importer::observePlace(document);
    const importer::Tree tree(place.document);
    level_ = importer::buildLevel(tree, place, "test");
    return level_;
  }
  // Returns the level's part for an instance. Fails the test if the level has none.
  const PartDraft& operator[](InstanceId id) const {
    static const PartDraft kNone;
    for (const auto& part : level_.parts)
      if (part.id == id) return part;
    ADD_FAILURE() << "instance " << id << " is no part of the level";
    return kNone;
  }
  std::string evidence(InstanceId id, const std::string& role) const {
    for (const auto& e : (*this)[id].evidence)
      if (e.role == role) return (e.guessed ? "guessed: " : "") + e.reason;
    return "";
  }
  uint32_t unmodelled(const std::string& kind) const {
    const auto it = level_.unmodelled.find(kind);
    return it == level_.unmodelled.end() ? 0 : it->second.count;
  }
  std::string noteOf(const std::string& kind) const {
    const auto it = level_.unmodelled.find(kind);
    return it == level_.unmodelled.end() ? "" : it->second.note;
  }

  Document document;
  InstanceId workspace = kNoInstance, scripts = kNoInstance;

 private:
  LevelDraft level_;
};

}  // namespace obby::test
