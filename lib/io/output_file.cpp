#include "io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
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

#include "base/hash.h"

namespace obby::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".obby-unfinished-";
constexpr std::string_view kPattern = "XXXXXX";  // mkostemp() replaces it with letters and digits
constexpr std::string_view kLocked = "locked";   // looks like one of these to removeLeftovers()
static_assert(kLocked.size() == kPattern.size());

// Returns true on NFS, SMB (three), Lustre and BeeGFS, by their numbers in statfs(2). There a lock
// may be known to one machine only, or wait for a server that does not respond.
bool onNetwork(int fd) {
  constexpr uint32_t kNetworks[] = {0x6969, 0x517B, 0xFF534D42, 0xFE534D42, 0x0BD00BD0, 0x19830326};
  struct statfs system {};
  if (fstatfs(fd, &system) != 0) return false;
  return std::find(std::begin(kNetworks), std::end(kNetworks), uint32_t(system.f_type)) !=
         std::end(kNetworks);
}

enum class Lock {
  held,   // locked until the last descriptor of this opening is closed
  taken,  // another opening has the lock
  none,   // files cannot be locked here
};

// Tries to lock a file, without waiting.
Lock lockOf(int fd) {
  if (onNetwork(fd)) return Lock::none;
  if (flock(fd, LOCK_EX | LOCK_NB) == 0) return Lock::held;
  return errno == EWOULDBLOCK ? Lock::taken : Lock::none;
}

// Returns true if `path` still names the file that was opened by it. Only the holder of the lock
// removes that name.
bool isNameOf(const std::string& path, int fd) {
  struct stat named {};
  struct stat opened {};
  return ::lstat(path.c_str(), &named) == 0 && ::fstat(fd, &opened) == 0 &&
         named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

// Locks a new file. Returns false if a search for leftovers was faster and has removed it. Where
// files cannot be locked, no search takes one for a leftover, and there is no `lock`.
bool lockOwn(TemporaryFile& file) {
  const Lock lock = lockOf(file.fd);
  if (lock != Lock::held) return lock == Lock::none;
  if (::access(file.path.c_str(), F_OK) != 0) return false;
  file.lock = fcntl(file.fd, F_DUPFD_CLOEXEC, 3);  // the same lock, which outlasts fd
  return true;
}

// Returns the beginning of the names of a file's temporary files. A name that is too long is cut
// and gets a hash of all of it, because names may begin alike.
std::string beginOf(const fs::path& file) {
  constexpr size_t kMost = NAME_MAX - kMark.size() - kPattern.size();  // bytes
  constexpr size_t kHash = 17;  // bytes: a dash and 64 bits in hexadecimal
  std::string name = file.filename().string();
  if (name.size() > kMost && name.size() <= NAME_MAX) {  // longer names are errors anyway
    const uint64_t hash = hashBytes(name.data(), name.size());
    size_t end = kMost - kHash;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) end--;  // UTF-8
    name.resize(end);
    name += fmt::format("-{:016x}", hash);
  }
  return name.append(kMark);
}

bool isTemporaryOf(const std::string& begin, const std::string& name) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  return name.size() == begin.size() + kPattern.size() && name.starts_with(begin) &&
         name.find_first_not_of(kLetters, begin.size()) == std::string::npos;
}

// Removes a file if its writer, and with it its lock, is gone.
void removeIfLeft(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY);
  if (fd < 0) return;
  struct stat info {};
  const bool left = fstat(fd, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == geteuid() &&
                    lockOf(fd) == Lock::held && isNameOf(path, fd);
  if (left) ::unlink(path.c_str());
  ::close(fd);
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

OutputLocks::~OutputLocks() {
  for (const Held& held : held_) {
    if (isNameOf(held.path, held.fd)) ::unlink(held.path.c_str());  // while it is still locked
    ::close(held.fd);
  }
}

bool OutputLocks::take(const std::string& path) {
  constexpr int kFlags = O_RDONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY;
  constexpr mode_t kMode = 0666;   // other users must see that it is held
  constexpr int kMostTries = 100;  // in case others keep locking and releasing it
  const fs::path file = linkTarget(path);
  const std::string name = (file.parent_path() / beginOf(file)).string().append(kLocked);
  for (int tries = 0; tries < kMostTries; tries++) {
    const int fd = ::open(name.c_str(), kFlags, kMode);
    if (fd < 0) return true;
    const Lock lock = lockOf(fd);
    if (lock == Lock::held && isNameOf(name, fd)) {
      held_.push_back({fd, name});
      return true;
    }
    const bool own = std::any_of(held_.begin(), held_.end(),
                                 [&](const Held& held) { return isNameOf(name, held.fd); });
    if (lock == Lock::none) ::unlink(name.c_str());
    ::close(fd);
    if (lock != Lock::held) return own || lock == Lock::none;
  }
  return false;
}

}  // namespace obby::io
