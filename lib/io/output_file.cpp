#include "io/output_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace obby::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".obby-";
constexpr std::string_view kPattern = "XXXXXX";  // mkostemp() makes letters and digits of it

// False: who looked for leftovers was faster, and has removed it. Where files cannot be locked
// nobody takes one for a leftover.
bool lockOwn(const TemporaryFile& file) {
  if (flock(file.fd, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  return ::access(file.path.c_str(), F_OK) == 0;
}

bool isTemporaryOf(const std::string& file, const std::string& name) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  const std::string begin = file + std::string(kMark);
  return name.size() == begin.size() + kPattern.size() && name.starts_with(begin) &&
         name.find_first_not_of(kLetters, begin.size()) == std::string::npos;
}

// If its writer is gone, and its lock with it.
void removeIfLeft(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
  if (fd < 0) return;
  struct stat info {};
  const bool left = fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == geteuid() &&
                    flock(fd, LOCK_EX | LOCK_NB) == 0;
  if (left) ::unlink(path.c_str());
  ::close(fd);
}

}  // namespace

std::string linkTarget(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the system has it
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
  constexpr int kMostTries = 100;
  TemporaryFile out;
  for (int tries = 0; tries < kMostTries; tries++) {
    out.path = path;
    out.path.append(kMark).append(kPattern);
    out.fd = mkostemp(out.path.data(), O_CLOEXEC);
    if (out.fd < 0) return out;
    if (lockOwn(out)) {
      out.lock = fcntl(out.fd, F_DUPFD_CLOEXEC, 3);  // the same lock: it outlasts fd
      return out;
    }
    ::close(out.fd);
  }
  out.fd = -1;
  errno = EBUSY;
  return out;
}

void removeLeftovers(const std::string& path) {
  const fs::path file = linkTarget(path);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<std::string> found;
  std::error_code unseen;
  for (fs::directory_iterator entry(folder, unseen), end; !unseen && entry != end;
       entry.increment(unseen)) {
    if (isTemporaryOf(file.filename().string(), entry->path().filename().string()))
      found.push_back(entry->path().string());
  }
  for (const std::string& left : found) removeIfLeft(left);
}

}  // namespace obby::io
