// Reads the files that a Rojo project may read: regular files below its folder and below the paths
// that the project's own file names. Links and nested projects cannot leave these.
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

  // Allows reading at or below `path` from now on.
  void allow(const fs::path& path);

  bool isFolder(const fs::path& path) const;
  bool isFile(const fs::path& path) const;

  // Marks the folder as open until leave(). Returns false, without effect, if it is open already: a
  // link or a path leads back.
  bool enter(const fs::path& folder);
  void leave() { open_.pop_back(); }

  // Returns the names in a folder, sorted. Fails if it is outside the allowed paths, or if the
  // project exceeds its limit of files.
  Result<std::vector<std::string>> list(const fs::path& folder);
  // Returns the bytes of a file. Fails if it is outside the allowed paths, or if the project
  // exceeds its limit of bytes.
  Result<std::string> read(const fs::path& file);

 private:
  Status check(const fs::path& path) const;

  std::vector<fs::path> roots_, open_;  // canonical
  const std::atomic<bool>* stop_;
  uint64_t bytesLeft_ = uint64_t(1) << 30;
  size_t filesLeft_ = 100000;
};

// Returns the text of a script as Rojo stores it, with \n as line breaks.
std::string withUnixLines(std::string text);

}  // namespace obby::importer::rojo
