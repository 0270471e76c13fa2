#include "io/sink.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include "io/byte_source.h"
#include "io/output_file.h"

namespace obby::io {
namespace {

constexpr size_t kBlock = size_t(256) << 10;
constexpr int kWaitMilliseconds = 50;
constexpr const char* kBrokenPipe = "the reader of the output has closed it (broken pipe)";

Error outputError(const std::string& name, const char* doing) {
  return errno == EPIPE ? Error{name, {}, {}, kBrokenPipe, {}} : fileError(name, doing);
}

// Waits until a file or folder is on the disk, if its file system supports that. Returns false on
// failure, with the reason in errno.
bool onDisk(int fd) {
  int result = 0;
  do {
    result = ::fsync(fd);
  } while (result != 0 && errno == EINTR);
  return result == 0 || errno == EINVAL;  // not supported
}

mode_t newFileMode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

}  // namespace

struct Sink::Impl {
  std::string name;
  int fd = -1;
  std::string* memory = nullptr;
  const std::atomic<bool>* stop = nullptr;
  std::string finalPath, temporaryPath;  // paths of a regular file until it is closed
  bool durable = false;                  // wait until that file is on the disk
  bool block = false;                    // collect pieces into blocks
  std::string buffer;
  std::optional<Error> failed;

  ~Impl() {
    if (fd >= 0) ::close(fd);
    if (!temporaryPath.empty()) ::unlink(temporaryPath.c_str());
  }

  Status fail(const char* doing) {
    failed = outputError(name, doing);
    return *failed;
  }

  Status send(std::string_view bytes) {
    return sendAll(fd, bytes, block ? nullptr : stop) ? Status() : fail("cannot write");
  }

  Status openStandardOutput() {
    name = "stdout";
    // A copy, so that closing it can be checked while descriptor 1 stays taken.
    fd = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (fd < 0) return fail("cannot write");
    struct stat info {};
    block = fstat(fd, &info) == 0 && S_ISREG(info.st_mode);
    return {};
  }

  Status openFile(const std::string& path) {
    name = path;
    if (path.empty()) {
      failed = makeError("the name of the output file is empty", "use - for standard output");
      return *failed;
    }
    struct stat info {};
    const bool exists = stat(path.c_str(), &info) == 0;
    if (exists && S_ISDIR(info.st_mode)) {
      errno = EISDIR;
      return fail("cannot write");
    }
    if (exists && !S_ISREG(info.st_mode)) {  // a device or named pipe
      fd = openToWrite(path, O_WRONLY, stop);
      return fd < 0 ? fail("cannot open") : Status();
    }
    finalPath = linkTarget(path);
    TemporaryFile made = makeTemporary(finalPath);
    fd = made.fd;
    if (fd < 0) return fail("cannot create");
    temporaryPath = std::move(made.path);
    block = true;
    if (fchmod(fd, exists ? info.st_mode & 0777 : newFileMode()) != 0) return fail("cannot create");
    return {};
  }

  Status flush() {
    if (failed) return *failed;
    if (memory || buffer.empty()) return {};
    const Status sent = send(buffer);
    buffer.clear();
    return sent;
  }

  // Must come before the file is renamed: otherwise its name may reach the disk before its
  // contents.
  Status syncFile() {
    if (!durable || temporaryPath.empty() || onDisk(fd)) return {};
    return fail("cannot write");
  }

  // Waits for the new name. Some folders cannot be opened; then the old file may be back after a
  // failure, complete.
  Status syncFolder() {
    if (!durable) return {};
    const size_t slash = finalPath.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : finalPath.substr(0, slash + 1);
    const int folderFd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folderFd < 0) return {};
    Status status = onDisk(folderFd) ? Status() : fail("cannot write");
    ::close(folderFd);
    return status;
  }
};

Result<Sink> Sink::open(const std::string& path, Durable durable, const std::atomic<bool>* stop) {
  auto impl = std::make_unique<Impl>();
  impl->stop = stop;
  impl->durable = durable == Durable::yes;
  OBBY_RETURN_IF_ERROR(path == "-" ? impl->openStandardOutput() : impl->openFile(path));
  return Sink(std::move(impl));
}

Sink Sink::toBytes(std::string* bytes) {
  auto impl = std::make_unique<Impl>();
  impl->name = "memory";
  impl->memory = bytes;
  return Sink(std::move(impl));
}

Sink::Sink(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Sink::Sink(Sink&&) noexcept = default;
Sink& Sink::operator=(Sink&&) noexcept = default;
Sink::~Sink() = default;

Status Sink::write(std::string_view piece) {
  if (impl_->failed) return *impl_->failed;
  if (impl_->memory) {
    impl_->memory->append(piece);
    return {};
  }
  if (!impl_->block) return impl_->send(piece);
  impl_->buffer.append(piece);
  return impl_->buffer.size() >= kBlock ? impl_->flush() : Status();
}

Status Sink::flush() { return impl_->flush(); }

Status Sink::close() {
  OBBY_RETURN_IF_ERROR(impl_->flush());
  if (impl_->fd < 0) return {};
  OBBY_RETURN_IF_ERROR(impl_->syncFile());
  const int result = ::close(impl_->fd);
  impl_->fd = -1;
  if (result != 0 && errno != EINTR) return impl_->fail("cannot write");
  if (impl_->temporaryPath.empty()) return {};
  if (::rename(impl_->temporaryPath.c_str(), impl_->finalPath.c_str()) != 0)
    return impl_->fail("cannot rename the finished file");
  impl_->temporaryPath.clear();
  return impl_->syncFolder();
}

bool Sink::terminal() const { return impl_->fd >= 0 && isatty(impl_->fd) == 1; }
bool Sink::failed() const { return impl_->failed.has_value(); }
const std::string& Sink::name() const { return impl_->name; }

bool takesMore(int fd, int milliseconds) {
  pollfd waiting{fd, POLLOUT, 0};
  int ready = 0;
  do {
    ready = ::poll(&waiting, 1, milliseconds);
  } while (ready < 0 && errno == EINTR);
  return ready != 0;
}

// Opening a named pipe waits for a reader. With `stop` the pipe is polled instead, because a signal
// may come just before the call that would wait.
int openToWrite(const std::string& path, int flags, const std::atomic<bool>* stop) {
  constexpr mode_t kMode = 0666;
  flags |= O_CLOEXEC | O_NOCTTY;
  struct stat info {};
  if (!stop || stat(path.c_str(), &info) != 0 || !S_ISFIFO(info.st_mode))
    return ::open(path.c_str(), flags, kMode);
  for (int late = 0; late < kPatienceMilliseconds;) {
    const int opened = ::open(path.c_str(), flags | O_NONBLOCK, kMode);
    if (opened >= 0 || errno != ENXIO) return opened;  // sendAll() waits for its reader
    if (stop->load(std::memory_order_relaxed)) late += kWaitMilliseconds;
    std::this_thread::sleep_for(std::chrono::milliseconds(kWaitMilliseconds));
  }
  errno = EINTR;
  return -1;
}

// Once told to stop, sends pieces so small that a pipe whose reader has taken something accepts one
// whole. No write waits then, and a reader that takes nothing is given up.
bool sendAll(int fd, std::string_view bytes, const std::atomic<bool>* stop) {
  while (!bytes.empty()) {
    const bool ends = stop && stop->load(std::memory_order_relaxed);
    if (ends && !takesMore(fd, kPatienceMilliseconds)) {
      errno = EINTR;
      return false;
    }
    const size_t most = ends ? std::min<size_t>(bytes.size(), PIPE_BUF) : bytes.size();
    const ssize_t sent = ::write(fd, bytes.data(), most);
    if (sent >= 0) {
      bytes.remove_prefix(size_t(sent));
    } else if (errno == EAGAIN) {
      // A terminal or socket that other programs write to, or that is also standard input, may be
      // non-blocking.
      takesMore(fd, stop ? kWaitMilliseconds : -1);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

bool isBrokenPipe(const Error& error) { return error.message == kBrokenPipe; }

}  // namespace obby::io
