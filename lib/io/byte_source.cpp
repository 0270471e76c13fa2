#include "io/byte_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace obby::io {
namespace {

constexpr size_t kLargestChunk = size_t(16) << 20;
constexpr int kStopCheckMilliseconds = 100;

// Opening a named pipe waits for a writer. If there is a `stop`, the first read waits instead.
int openFile(const std::string& path, bool mayStop) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | (mayStop ? O_NONBLOCK : 0));
  if (fd >= 0 && mayStop) fcntl(fd, F_SETFL, O_RDONLY);
  return fd;
}

Error tooLarge(const std::string& name, uint64_t max, const std::string& found) {
  return Error{name,
               {},
               {},
               fmt::format("expected at most {} bytes, found {}", max, found),
               "this file is read into memory whole; give a smaller one"};
}

}  // namespace

Error fileError(const std::string& name, const char* doing) {
  Error error = makeError(errno == EINTR ? std::string(kInterrupted)
                                         : std::string(doing) + ": " + std::strerror(errno));
  error.input = name;
  return error;
}

Result<ByteSource> ByteSource::open(const std::string& path, const std::atomic<bool>* stop) {
  ByteSource out;
  const bool standard = path == "-";
  out.name_ = standard ? kStandardInput : path;
  out.stop_ = stop;
  out.fd_ = standard ? STDIN_FILENO : openFile(path, stop != nullptr);
  if (out.fd_ < 0) return fileError(out.name_, "cannot open");
  struct stat info {};
  if (fstat(out.fd_, &info) != 0) return fileError(out.name_, "cannot read");
  if (S_ISDIR(info.st_mode)) {
    errno = EISDIR;
    return fileError(out.name_, "cannot read");
  }
  out.regular_ = S_ISREG(info.st_mode);
  return out;
}

ByteSource ByteSource::overBytes(std::string bytes, std::string name) {
  ByteSource out;
  out.name_ = std::move(name);
  out.buffer_ = std::move(bytes);
  out.ended_ = true;
  return out;
}

ByteSource::ByteSource(ByteSource&& other) noexcept { *this = std::move(other); }

ByteSource& ByteSource::operator=(ByteSource&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(buffer_, other.buffer_);
  std::swap(begin_, other.begin_);
  std::swap(offset_, other.offset_);
  std::swap(fd_, other.fd_);
  std::swap(regular_, other.regular_);
  std::swap(ended_, other.ended_);
  std::swap(stopped_, other.stopped_);
  std::swap(stop_, other.stop_);
  return *this;
}

ByteSource::~ByteSource() {
  if (fd_ > STDIN_FILENO) ::close(fd_);
}

void ByteSource::consume(size_t bytes) {
  begin_ += bytes;
  offset_ += bytes;
  if (begin_ == buffer_.size()) {
    buffer_.clear();
    begin_ = 0;
    if (buffer_.capacity() > kLargestChunk) buffer_.shrink_to_fit();
  } else if (fd_ >= 0 && begin_ > kChunk && begin_ > buffer_.size() / 2) {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }
}

bool ByteSource::waitReadable() const {
  if (!stop_ || regular_) return true;
  pollfd waiting{fd_, POLLIN, 0};
  while (!stop_->load(std::memory_order_relaxed)) {
    const int ready = ::poll(&waiting, 1, kStopCheckMilliseconds);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;  // read() reports the error
  }
  return false;
}

// Called after a read has failed. Returns true to try again. An input that other programs share,
// such as a terminal or a socket, may be non-blocking. In that case this waits.
bool ByteSource::readAgain() const {
  if (errno == EAGAIN && !stop_) {
    pollfd waiting{fd_, POLLIN, 0};
    return ::poll(&waiting, 1, -1) >= 0;  // a signal interrupts poll() as it interrupts a read
  }
  return errno == EAGAIN || (errno == EINTR && stop_);  // true to wait again, or to check `stop`
}

Result<size_t> ByteSource::fill() {
  if (ended_) return size_t(0);
  const size_t before = buffer_.size();
  const size_t chunk = std::clamp(before - begin_, kChunk, max_);
  buffer_.resize(before + chunk);
  ssize_t got = 0;
  do {
    stopped_ = !waitReadable();
    got = stopped_ ? 0 : ::read(fd_, buffer_.data() + before, chunk);
  } while (got < 0 && readAgain());
  buffer_.resize(before + size_t(std::max<ssize_t>(got, 0)));
  if (got < 0) return fileError(name_, "cannot read");
  // A read from a file returns all requested bytes, a read from a pipe only the bytes that it
  // holds. A larger buffer for a pipe would be cleared for nothing.
  max_ = size_t(got) == chunk ? std::min(2 * chunk, kLargestChunk) : kChunk;
  ended_ = got == 0;
  return size_t(got);
}

// Returns the bytes of a regular file that are not read yet.
uint64_t ByteSource::leftInFile() const {
  struct stat info {};
  if (fd_ < 0 || !regular_ || fstat(fd_, &info) != 0) return 0;
  const off_t at = ::lseek(fd_, 0, SEEK_CUR);
  return at >= 0 && at < info.st_size ? uint64_t(info.st_size - at) : 0;
}

Result<std::string> ByteSource::rest(uint64_t max) {
  const uint64_t claimed = buffer_.size() - begin_ + leftInFile();
  if (claimed > max) return tooLarge(name_, max, fmt::format("{}", claimed));
  for (;;) {
    OBBY_ASSIGN(const size_t came, fill());
    if (came == 0) break;
    if (buffer_.size() - begin_ > max) return tooLarge(name_, max, "more");
  }
  buffer_.erase(0, std::exchange(begin_, 0));
  offset_ += buffer_.size();
  return std::exchange(buffer_, {});
}

Result<bool> ByteSource::need(size_t bytes) {
  while (buffer_.size() - begin_ < bytes) {
    OBBY_ASSIGN(const size_t came, fill());
    if (came == 0) return false;
  }
  return true;
}

}  // namespace obby::io
