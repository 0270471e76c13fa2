// What a tool writes must take the place of nothing that it reads, or writes elsewhere: a mistyped
// name would cost a place file, recordings, or an hour of learning.
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "cli/arguments.h"

namespace obby::cli {

struct WrittenFile {
  std::string option;  // without dashes, that it goes by; empty: standard output
  std::string path;    // "-": standard output; empty: nothing is written
};

// Error: one of `written` is an input, the file of another option that is given, or what one before
// it is; it names the option and the file. Files are the same by device and number on the disk,
// under whatever names; those that are not there yet by where they would be. Devices, pipes and
// folders may be shared, and the file of an option that is `renewed` be written.
Status refuseOverwriting(const Arguments& arguments, std::span<const WrittenFile> written);

}  // namespace obby::cli
