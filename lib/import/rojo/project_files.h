// The files that a Rojo project may read: regular ones below its folder, and below the paths that
// the project's own file names. Links and nested projects lead nowhere else.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace obby::importer::rojo {

namespace fs = std::filesystem;

class ProjectFiles {
 public:
  explicit ProjectFiles(const std::atomic<bool>* stop) : stop_(stop) {}

  // From here on what is at or below `path` may be read.
  void allow(const fs::path& path);

  bool isFolder(const fs::path& path) const;
  bool isFile(const fs::path& path) const;

  // Until leave() the folder is open. False, and nothing to leave: it is open already, so that a
  // link or a path leads back.
  bool enter(const fs::path& folder);
  void leave() { open_.pop_back(); }

  // Names in a folder, sorted. Error: it leads out of what is allowed.
  Result<std::vector<std::string>> list(const fs::path& folder);
  // Error: as of list(), or the files have more bytes or are more than a project may have.
  Result<std::string> read(const fs::path& file);

 private:
  Status check(const fs::path& path) const;

  std::vector<fs::path> roots_, open_;  // canonical
  const std::atomic<bool>* stop_;
  uint64_t bytesLeft_ = uint64_t(1) << 30;
  size_t filesLeft_ = 100000;
};

// The text of a script as Rojo has it: with line ends of one character.
std::string withUnixLines(std::string text);

}  // namespace obby::importer::rojo
