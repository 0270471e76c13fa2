#include "io/appender.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <tuple>
#include <utility>

#include "io/byte_source.h"
#include "io/sink.h"

namespace obby::io {

Result<Appender> Appender::open(const std::string& path, const std::atomic<bool>* stop) {
  const int fd = openToWrite(path, O_WRONLY | O_CREAT | O_APPEND, stop);
  if (fd < 0) return fileError(path, "cannot open");
  return Appender(path, fd, stop);
}

Appender::Appender(Appender&& other) noexcept
    : path_(std::move(other.path_)), fd_(std::exchange(other.fd_, -1)), stop_(other.stop_) {}

Appender& Appender::operator=(Appender&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  std::swap(stop_, other.stop_);
  return *this;
}

Appender::~Appender() {
  if (fd_ >= 0) ::close(fd_);
}

bool Appender::isRegular() const {
  struct stat file {};
  return ::fstat(fd_, &file) == 0 && S_ISREG(file.st_mode);
}

Status Appender::append(std::string_view piece) {
  const off_t before = isRegular() ? ::lseek(fd_, 0, SEEK_END) : -1;
  if (sendAll(fd_, piece, stop_)) return {};
  Error error = fileError(path_, "cannot write");
  // Removes the part of the piece that a full disk accepted.
  if (before >= 0) std::ignore = ::ftruncate(fd_, before);
  return error;
}

}  // namespace obby::io
