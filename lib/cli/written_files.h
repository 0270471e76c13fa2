// Keeps a tool's output from replacing anything that the tool reads, or writes elsewhere. A
// mistyped name would cost a place file, recordings, or an hour of training.
#pragma once

#include <span>
#include <string>

#include "base/result.h"
#include "cli/arguments.h"

namespace obby::cli {

struct WrittenFile {
  std::string option;  // the option that names the file, without dashes; empty for standard output
  std::string path;    // "-" for standard output; empty if nothing is written
};

// Returns an error if one of `written` is an input, the file of another given option, or an earlier
// entry of `written`. The error names the option and the file. Existing files are compared by
// device and inode, whatever their names; missing ones by their path. Devices, pipes and folders
// may be shared, and the file of a `renewed` option may be written.
Status refuseOverwriting(const Arguments& arguments, std::span<const WrittenFile> written);

}  // namespace obby::cli
