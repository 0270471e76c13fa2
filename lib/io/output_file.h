// Files on their way to their name: which one a symbolic link stands for, how a file is called
// until it is whole, and what killed writers left under such names.
#pragma once

#include <string>

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
// its name, of which a very long one loses its end.
TemporaryFile makeTemporary(const std::string& path);

// Removes what writers of `path` that were killed left beside it. What is still being written
// stays, and so do all files of other names, of other users, and those that cannot be locked or
// lie on a file system of a network, where locks do not tell.
void removeLeftovers(const std::string& path);

}  // namespace obby::io
