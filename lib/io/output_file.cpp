#include "io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/hash.h"
#include "io/byte_source.h"
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
  const size_t longest = NAME_MAX - kMark.size() - end.size();
  if (name.size() > longest && name.size() <= NAME_MAX) {  // names over NAME_MAX remain an error
    const std::string digest =
        fmt::format("-{:08x}", uint32_t(hashBytes(name.data(), name.size())));
    name = std::string(cutAtChar(name, longest - digest.size())) + digest;
  }
  return (file.parent_path() / name.append(kMark).append(end)).string();
}

// Waits until a file or folder is on the disk, if its file system supports that. Returns false on
// failure, with the reason in errno.
bool onDisk(int fd) {
  int result = 0;
  do {
    result = ::fsync(fd);
  } while (result != 0 && errno == EINTR);
  return result == 0 || errno == EINVAL;  // EINVAL: the file system does not support it
}

mode_t modeFor(const std::string& path, mode_t mode) {
  struct stat info {};
  if (stat(path.c_str(), &info) == 0) return info.st_mode & 0777;
  const mode_t mask = umask(0);
  umask(mask);
  return mode & ~mask;
}

}  // namespace

std::string linkTarget(const std::string& path) {
  constexpr int kMaxLinks = 40;  // the system's limit
  fs::path file = path;
  std::error_code none;
  for (int links = 0; links < kMaxLinks && fs::is_symlink(file, none); links++) {
    const fs::path named = fs::read_symlink(file, none);
    if (none) break;
    file = file.parent_path() / named;
  }
  return file.string();
}

Result<std::unique_ptr<OutputFile>> OutputFile::create(const std::string& path, mode_t mode) {
  std::unique_ptr<OutputFile> out(new OutputFile(path));
  out->target_ = linkTarget(path);
  std::string name = marked(out->target_, kPattern);
  out->fd_ = mkostemp(name.data(), O_CLOEXEC);
  if (out->fd_ < 0) return fileError(path, "cannot create");
  out->temporary_ = std::move(name);
  if (fchmod(out->fd_, modeFor(path, mode)) != 0) return fileError(path, "cannot create");
  return out;
}

OutputFile::~OutputFile() {
  if (fd_ >= 0) ::close(fd_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

// The contents must be on the disk before the rename. Otherwise a crash could leave the new name
// without the contents.
Status OutputFile::close(bool durable) {
  if (durable && !onDisk(fd_)) return fileError(path_, "cannot write");
  const int result = ::close(std::exchange(fd_, -1));
  if (result != 0 && errno != EINTR) return fileError(path_, "cannot write");
  return {};
}

Status OutputFile::finish(bool durable) {
  OBBY_RETURN_IF_ERROR(close(durable));
  if (::rename(temporary_.c_str(), target_.c_str()) != 0)
    return fileError(path_, "cannot rename the finished file");
  temporary_.clear();
  return durable ? syncFolder() : Status();
}

// Waits until the new name is on the disk. Some folders cannot be opened; then a failure of the
// machine may bring the old file back, complete.
Status OutputFile::syncFolder() const {
  const fs::path parent = fs::path(target_).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return {};
  Status status;
  if (!onDisk(fd)) status = fileError(path_, "cannot write");
  ::close(fd);
  return status;
}

OutputLocks::~OutputLocks() {
  for (const Held& held : held_) {
    ::unlink(held.path.c_str());  // removes the lock file while it is still locked
    ::close(held.fd);
  }
}

bool OutputLocks::take(const std::string& path) {
  constexpr int kFlags = O_RDONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
  const std::string name = marked(linkTarget(path), kLocked);
  for (;;) {
    const int fd = ::open(name.c_str(), kFlags, 0666);
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
    if (removed) continue;  // the holder of the lock removed the file just now
    if (!taken) ::unlink(name.c_str());
    return !taken;
  }
}

}  // namespace obby::io
