// A Rojo project as the place that Rojo would build of it.
#pragma once

#include <atomic>
#include <string>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer::rojo {

// Whether a path is a project to read: a folder, or a file named as projects are.
bool isProject(const std::string& path);

struct Project {
  std::string name;
  Document document;
};

// Errors name the file, and the keys in it. `stop` as io::readFile has it.
Result<Project> readProject(const std::string& path, const std::atomic<bool>* stop = nullptr);

}  // namespace obby::importer::rojo
