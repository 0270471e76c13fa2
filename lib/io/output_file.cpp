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
constexpr std::string_view kPattern = "XXXXXX";  // mkostemp() makes letters and digits of it
constexpr std::string_view kLocked = "locked";   // removeLeftovers() takes it for one of these
static_assert(kLocked.size() == kPattern.size());

// By their numbers in statfs(2): NFS, SMB (three), Lustre, BeeGFS. There a lock may be known to one
// machine only, or wait for a server that does not answer.
bool onNetwork(int fd) {
  constexpr uint32_t kNetworks[] = {0x6969, 0x517B, 0xFF534D42, 0xFE534D42, 0x0BD00BD0, 0x19830326};
  struct statfs system {};
  if (fstatfs(fd, &system) != 0) return false;
  return std::find(std::begin(kNetworks), std::end(kNetworks), uint32_t(system.f_type)) !=
         std::end(kNetworks);
}

enum class Lock {
  held,   // until the last descriptor of this opening is closed
  taken,  // by somebody else
  none,   // files are not locked here
};

// Does not wait.
Lock lockOf(int fd) {
  if (onNetwork(fd)) return Lock::none;
  if (flock(fd, LOCK_EX | LOCK_NB) == 0) return Lock::held;
  return errno == EWOULDBLOCK ? Lock::taken : Lock::none;
}

// Is `path` still the name of what was opened by it? Only who holds the lock takes that name away.
bool isNameOf(const std::string& path, int fd) {
  struct stat named {};
  struct stat opened {};
  return ::lstat(path.c_str(), &named) == 0 && ::fstat(fd, &opened) == 0 &&
         named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

// False: who looked for leftovers was faster, and has removed it. Where files cannot be locked
// nobody takes one for a leftover, and there is no `lock`.
bool lockOwn(TemporaryFile& file) {
  const Lock lock = lockOf(file.fd);
  if (lock != Lock::held) return lock == Lock::none;
  if (::access(file.path.c_str(), F_OK) != 0) return false;
  file.lock = fcntl(file.fd, F_DUPFD_CLOEXEC, 3);  // the same lock: it outlasts fd
  return true;
}

// How names of its temporary files begin: of a name that leaves no room for more only a part, and a
// hash of all of it, for names may begin alike.
std::string beginOf(const fs::path& file) {
  constexpr size_t kMost = NAME_MAX - kMark.size() - kPattern.size();  // bytes
  constexpr size_t kHash = 17;  // bytes: a dash and 64 bits in hexadecimal
  std::string name = file.filename().string();
  if (name.size() > kMost && name.size() <= NAME_MAX) {  // longer ones are to be refused at once
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

// If its writer is gone, and its lock with it.
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

OutputLocks::~OutputLocks() {
  for (const Held& held : held_) {
    if (isNameOf(held.path, held.fd)) ::unlink(held.path.c_str());  // before others can have it
    ::close(held.fd);
  }
}

bool OutputLocks::take(const std::string& path) {
  constexpr int kFlags = O_RDONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY;
  constexpr mode_t kMode = 0666;   // other users are to see that it is held
  constexpr int kMostTries = 100;  // of who always comes when another has just given it back
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
