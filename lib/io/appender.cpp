#include "io/appender.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace obby::io {
namespace {

Error failure(const std::string& path, const char* doing) {
  return Error{path, {}, {}, std::string(doing) + ": " + std::strerror(errno), {}};
}

}  // namespace

Result<Appender> Appender::open(const std::string& path) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOCTTY, 0666);
  if (fd < 0) return failure(path, "cannot open");
  return Appender(path, fd);
}

Appender::Appender(Appender&& other) noexcept
    : path_(std::move(other.path_)), fd_(std::exchange(other.fd_, -1)) {}

Appender& Appender::operator=(Appender&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  return *this;
}

Appender::~Appender() {
  if (fd_ >= 0) ::close(fd_);
}

Status Appender::append(std::string_view piece) {
  while (!piece.empty()) {
    const ssize_t sent = ::write(fd_, piece.data(), piece.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return failure(path_, "cannot write");
    piece.remove_prefix(size_t(sent));
  }
  return {};
}

}  // namespace obby::io
