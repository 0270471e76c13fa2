#include "bridge/programs.h"

#include <unistd.h>

#include <filesystem>

namespace obby::bridge {
namespace {

namespace fs = std::filesystem;

bool isProgram(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

Result<Programs> findPrograms(const std::string& solve) {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  const auto sibling = [&](const char* name) {
    return !error && isProgram(here / name) ? (here / name).string() : std::string();
  };
  Programs out{sibling("obby-solve"), sibling("obby-import"), sibling("obby-calibrate")};
  if (!solve.empty()) {
    out.solve = fs::absolute(solve, error).string();
    if (error || !isProgram(out.solve))
      return Error{solve, {}, {}, "this is not an executable program", {}};
  }
  if (out.solve.empty()) {
    return makeError("there is no obby-solve next to obby-bridge",
                     "give the path of one with --solve");
  }
  return out;
}

}  // namespace obby::bridge
