// The commit that this program was built from.
#pragma once

namespace obby::cli {

// Ten hexadecimal digits, or what the build was told; empty: not known. Generated, see
// cmake/ObbyVersion.cmake.
extern const char* const kCommit;

}  // namespace obby::cli
