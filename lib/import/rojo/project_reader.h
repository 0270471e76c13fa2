// Reads a Rojo project as the place that Rojo would build from it.
#pragma once

#include <atomic>
#include <string>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer::rojo {

// Returns true if the path is a project: a folder, or a file with a project's name.
bool isProject(const std::string& path);

struct Project {
  std::string name;
  Document document;
};

// Reads a project. Errors name the file and the keys in it. `stop` is that of io::readFile.
Result<Project> readProject(const std::string& path, const std::atomic<bool>* stop = nullptr);

}  // namespace obby::importer::rojo
