#include "io/output_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <vector>

namespace obby::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".obby-unfinished-";
constexpr std::string_view kPattern = "XXXXXX";  // mkostemp() makes letters and digits of it

// By their numbers in statfs(2): NFS, SMB (three), Lustre, BeeGFS. There a lock may be known to one
// machine only, or wait for a server that does not answer.
bool onNetwork(int fd) {
  constexpr uint32_t kNetworks[] = {0x6969, 0x517B, 0xFF534D42, 0xFE534D42, 0x0BD00BD0, 0x19830326};
  struct statfs system {};
  if (fstatfs(fd, &system) != 0) return false;
  return std::find(std::begin(kNetworks), std::end(kNetworks), uint32_t(system.f_type)) !=
         std::end(kNetworks);
}

// False: who looked for leftovers was faster, and has removed it. Where files cannot be locked
// nobody takes one for a leftover, and there is no `lock`.
bool lockOwn(TemporaryFile& file) {
  if (onNetwork(file.fd)) return true;
  if (flock(file.fd, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  if (::access(file.path.c_str(), F_OK) != 0) return false;
  file.lock = fcntl(file.fd, F_DUPFD_CLOEXEC, 3);  // the same lock: it outlasts fd
  return true;
}

// How names of its temporary files begin: of a name that leaves no room for more only a part.
std::string beginOf(const fs::path& file) {
  constexpr size_t kMost = NAME_MAX - kMark.size() - kPattern.size();  // bytes
  std::string name = file.filename().string();
  if (name.size() > kMost && name.size() <= NAME_MAX) {  // longer ones are to be refused at once
    size_t end = kMost;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) end--;  // UTF-8
    name.resize(end);
  }
  return name.append(kMark);
}

bool isTemporaryOf(const std::string& begin, const std::string& name) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  return name.size() == begin.size() + kPattern.size() && name.starts_with(begin) &&
         name.find_first_not_of(kLetters, begin.size()) == std::string::npos;
}

// If its writer is gone, and its lock with it.
void removeIfLeft(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
  if (fd < 0) return;
  struct stat info {};
  const bool left = fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == geteuid() &&
                    !onNetwork(fd) && flock(fd, LOCK_EX | LOCK_NB) == 0;
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
    out.path = (fs::path(path).parent_path() / beginOf(path)).string().append(kPattern);
    out.fd = mkostemp(out.path.data(), O_CLOEXEC);
    if (out.fd < 0) return out;
    if (lockOwn(out)) return out;
    ::close(out.fd);
  }
  out.fd = -1;
  errno = EBUSY;
  return out;
}

void removeLeftovers(const std::string& path) {
  const fs::path file = linkTarget(path);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const std::string begin = beginOf(file);
  std::vector<std::string> found;
  std::error_code unseen;
  for (fs::directory_iterator entry(folder, unseen), end; !unseen && entry != end;
       entry.increment(unseen)) {
    if (isTemporaryOf(begin, entry->path().filename().string()))
      found.push_back(entry->path().string());
  }
  for (const std::string& left : found) removeIfLeft(left);
}

}  // namespace obby::io
