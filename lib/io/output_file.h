// Files on their way to their name: which one a symbolic link stands for, how a file is called
// until it is whole, what killed writers left under such names, and who alone may write a file.
#pragma once

#include <string>
#include <vector>

namespace obby::io {

// The file that is written where `path` is asked for: the one that a symbolic link names, even if
// it is not there yet, so that the link stays one.
std::string linkTarget(const std::string& path);

// A new file of one writer. Both descriptors are the caller's to close: `lock` only once the file
// has its lasting name or is removed, for until then it tells the file from a leftover.
struct TemporaryFile {
  int fd = -1;    // to write; -1: it could not be made, and errno says why
  int lock = -1;  // ends with the process, whatever ends that; -1: files are not locked here
  std::string path;
};

// Beside `path`, which it is to become: with ".obby-unfinished-" and six letters or digits behind
// its name, of which a very long one has a hash in the place of its end.
TemporaryFile makeTemporary(const std::string& path);

// Removes what writers of `path` that were killed left beside it. What is still being written
// stays, and so do all files of other names, of other users, and those that cannot be locked or
// lie on a file system of a network, where locks do not tell.
void removeLeftovers(const std::string& path);

// Files that one process writes again and again, and that no other is to write meanwhile: each is
// held by a locked file beside it, with ".obby-unfinished-locked" behind its name. It goes with
// this object; what a killed process leaves of it is not locked, hinders nobody, and is a leftover
// like others.
class OutputLocks {
 public:
  OutputLocks() = default;
  ~OutputLocks();
  OutputLocks(const OutputLocks&) = delete;
  OutputLocks& operator=(const OutputLocks&) = delete;

  // Keeps the file of that name, which need not be there, whatever path leads to it. Does not wait.
  // False: another object has it, of this process or of another. True as well where it cannot be
  // told: the file beside it cannot be made, or locked, or lies on a file system of a network.
  [[nodiscard]] bool take(const std::string& path);

 private:
  struct Held {
    int fd;
    std::string path;  // of the locked file
  };
  std::vector<Held> held_;
};

}  // namespace obby::io
