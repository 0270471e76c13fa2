// Files that appear under their name only when they are complete, and locks that allow a file only
// one writer.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace obby::io {

// Returns the file to write for `path`. It is the target of a symbolic link, even if that does not
// exist yet, so that the link remains.
std::string linkTarget(const std::string& path);

// A regular file under a temporary name. Only a killed process leaves the temporary file behind.
class OutputFile {
 public:
  // Makes a file next to `path`, which it is to become. It has ".obby-unfinished-" and six letters
  // or digits after its name; a very long name is cut. It gets the mode of the existing file, or
  // `mode` less the process's mask. Errors name `path`.
  static Result<std::unique_ptr<OutputFile>> create(const std::string& path, mode_t mode = 0666);
  ~OutputFile();  // removes the file if finish() has not succeeded
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  int fd() const { return fd_; }
  // Closes the file and gives it its name. With `durable`, waits until it is on the disk under that
  // name. On failure `path` still names the old file, unless only the wait for the new name failed.
  Status finish(bool durable);

 private:
  explicit OutputFile(const std::string& path) : path_(path) {}
  Status close(bool durable);
  Status syncFolder() const;

  // Path as given; path with links resolved; temporary path, empty once finished.
  std::string path_, target_, temporary_;
  int fd_ = -1;
};

// Locks on files that one process writes repeatedly, and that no other process may write meanwhile.
// A lock file next to each, with ".obby-unfinished-locked" after its name, reserves it until this
// object ends. A lock file left by a killed process is not locked, so it blocks no process.
class OutputLocks {
 public:
  OutputLocks() = default;
  ~OutputLocks();
  OutputLocks(const OutputLocks&) = delete;
  OutputLocks& operator=(const OutputLocks&) = delete;

  // Locks the file at `path`, which need not exist, under all paths that lead to it. Does not wait.
  // Returns false if another object has the lock, in this process or another. Returns true also if
  // files cannot be locked there.
  [[nodiscard]] bool take(const std::string& path);

 private:
  struct Held {
    int fd;
    std::string path;  // path of the lock file
  };
  std::vector<Held> held_;
};

}  // namespace obby::io
