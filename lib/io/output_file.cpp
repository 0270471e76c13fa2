#include "io/output_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "io/utf8.h"

namespace obby::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".obby-unfinished-";
constexpr std::string_view kPattern = "XXXXXX";  // mkostemp() replaces it with letters and digits
constexpr std::string_view kLocked = "locked";
static_assert(kLocked.size() == kPattern.size());

std::string marked(const fs::path& file, std::string_view end) {
  std::string name = file.filename().string();
  // A name that no file can have stays an error.
  if (name.size() <= NAME_MAX) name = cutAtChar(name, NAME_MAX - kMark.size() - end.size());
  return (file.parent_path() / name.append(kMark).append(end)).string();
}

}  // namespace

std::string linkTarget(const std::string& path) {
  constexpr int kMostLinks = 40;  // the system's limit
  fs::path file = path;
  std::error_code none;
  for (int links = 0; links < kMostLinks && fs::is_symlink(file, none); links++) {
    const fs::path named = fs::read_symlink(file, none);
    if (none) break;
    file = file.parent_path() / named;
  }
  return file.string();
}

TemporaryFile makeTemporary(const std::string& path) {
  TemporaryFile out{-1, marked(path, kPattern)};
  out.fd = mkostemp(out.path.data(), O_CLOEXEC);
  return out;
}

OutputLocks::~OutputLocks() {
  for (const Held& held : held_) {
    ::unlink(held.path.c_str());  // while it is still locked
    ::close(held.fd);
  }
}

bool OutputLocks::take(const std::string& path) {
  const std::string name = marked(linkTarget(path), kLocked);
  for (;;) {
    const int fd = ::open(name.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (fd < 0) return true;
    const bool locked = flock(fd, LOCK_EX | LOCK_NB) == 0;
    const bool taken = !locked && errno == EWOULDBLOCK;
    struct stat info {};
    const bool removed = locked && fstat(fd, &info) == 0 && info.st_nlink == 0;
    if (locked && !removed) {
      held_.push_back({fd, name});
      return true;
    }
    ::close(fd);
    if (removed) continue;  // its holder ended just now
    if (!taken) ::unlink(name.c_str());
    return !taken;
  }
}

}  // namespace obby::io
