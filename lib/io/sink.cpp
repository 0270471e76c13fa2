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
constexpr const char* kBrokenPipe =
    "the program that reads the output closed it early (broken pipe)";

Error outputError(const std::string& name, const char* doing) {
  return errno == EPIPE ? Error{name, {}, {}, kBrokenPipe, {}} : fileError(name, doing);
}

}  // namespace

struct Sink::Impl {
  std::string name;
  int fd = -1;
  std::string* memory = nullptr;
  const std::atomic<bool>* stop = nullptr;
  std::unique_ptr<OutputFile> file;  // owns the descriptor of a file
  bool durable = false;              // wait until that file is on the disk
  bool block = false;                // collect pieces into blocks
  std::string buffer;
  std::optional<Error> failed;

  ~Impl() {
    if (fd >= 0 && !file) ::close(fd);
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
    OBBY_ASSIGN(file, OutputFile::create(path));
    fd = file->fd();
    block = true;
    return {};
  }

  Status flush() {
    if (failed) return *failed;
    if (memory || buffer.empty()) return {};
    const Status sent = send(buffer);
    buffer.clear();
    return sent;
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
  const int fd = std::exchange(impl_->fd, -1);
  if (impl_->file) {
    const Status finished = impl_->file->finish(impl_->durable);
    if (!finished) impl_->failed = finished.error();
    return finished;
  }
  return ::close(fd) == 0 || errno == EINTR ? Status() : impl_->fail("cannot write");
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

// Once asked to stop, sends small pieces. A pipe accepts one whole as soon as its reader has taken
// something. Thus no write waits, and a reader that takes nothing is given up.
bool sendAll(int fd, std::string_view bytes, const std::atomic<bool>* stop) {
  while (!bytes.empty()) {
    const bool ends = stop && stop->load(std::memory_order_relaxed);
    if (ends && !takesMore(fd, kPatienceMilliseconds)) {
      errno = EINTR;
      return false;
    }
    const size_t max = ends ? std::min<size_t>(bytes.size(), PIPE_BUF) : bytes.size();
    const ssize_t sent = ::write(fd, bytes.data(), max);
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
