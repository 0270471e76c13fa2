// Files before they get their final name: the target of a symbolic link, the name of an incomplete
// file, leftovers of killed writers, and locks that allow a file only one writer.
#pragma once

#include <string>
#include <vector>

namespace obby::io {

// Returns the file to write for `path`. It is the target of a symbolic link, even if that does not
// exist yet, so that the link remains.
std::string linkTarget(const std::string& path);

// A new file of one writer. The caller closes both descriptors. `lock` must stay open until the
// file has its final name or is removed, because it tells the file from a leftover.
struct TemporaryFile {
  int fd = -1;    // to write; -1 if the file could not be made, with the reason in errno
  int lock = -1;  // ends with the process; -1 if files cannot be locked here
  std::string path;
};

// Makes a file next to `path`, which it is to become. It has ".obby-unfinished-" and six letters or
// digits after its name; a hash replaces the end of a very long name.
TemporaryFile makeTemporary(const std::string& path);

// Removes files next to `path` that killed writers of it have left. Files that are still being
// written stay. So do files of other names and other users, files that cannot be locked, and files
// on a network file system, where locks are not reliable.
void removeLeftovers(const std::string& path);

// Files that one process writes repeatedly, and that no other may write meanwhile. A locked file
// next to each holds it, with ".obby-unfinished-locked" after its name. It is removed with this
// object. The lock file of a killed process is not locked; it blocks no other process, and is a
// leftover like others.
class OutputLocks {
 public:
  OutputLocks() = default;
  ~OutputLocks();
  OutputLocks(const OutputLocks&) = delete;
  OutputLocks& operator=(const OutputLocks&) = delete;

  // Locks the file of that name, which need not exist, whatever path leads to it. Does not wait.
  // Returns false if another object has it, of this process or of another. Also returns true if the
  // lock file cannot be made or locked, or is on a network file system.
  [[nodiscard]] bool take(const std::string& path);

 private:
  struct Held {
    int fd;
    std::string path;  // path of the locked file
  };
  std::vector<Held> held_;
};

}  // namespace obby::io
