// Files before they get their final name, and locks that allow a file only one writer.
#pragma once

#include <string>
#include <vector>

namespace obby::io {

// Returns the file to write for `path`. It is the target of a symbolic link, even if that does not
// exist yet, so that the link remains.
std::string linkTarget(const std::string& path);

// A new file that its writer renames, or removes. fd is -1 if it cannot be made, with the reason in
// errno.
struct TemporaryFile {
  int fd = -1;
  std::string path;
};

// Makes a file next to `path`, which it is to become. It has ".obby-unfinished-" and six letters or
// digits after its name; a very long name is cut.
TemporaryFile makeTemporary(const std::string& path);

// Files that one process writes repeatedly, and that no other may write meanwhile. A locked file
// next to each holds it, with ".obby-unfinished-locked" after its name. It is removed with this
// object. That of a killed process is not locked, so it blocks no other.
class OutputLocks {
 public:
  OutputLocks() = default;
  ~OutputLocks();
  OutputLocks(const OutputLocks&) = delete;
  OutputLocks& operator=(const OutputLocks&) = delete;

  // Locks the file of that name, which need not exist, whatever path leads to it. Does not wait.
  // Returns false if another object has it, of this process or of another; true also if files
  // cannot be locked there.
  [[nodiscard]] bool take(const std::string& path);

 private:
  struct Held {
    int fd;
    std::string path;  // path of the locked file
  };
  std::vector<Held> held_;
};

}  // namespace obby::io
