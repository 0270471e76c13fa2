// The commit that this program was built from.
#pragma once

namespace obby::cli {

// Ten hexadecimal digits, or the name that the build was given; empty if unknown.
// cmake/ObbyVersion.cmake generates the value.
extern const char* const kCommit;

}  // namespace obby::cli
