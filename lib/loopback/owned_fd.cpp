#include "loopback/owned_fd.h"

#include <unistd.h>

#include <utility>

namespace obby::loopback {

OwnedFd& OwnedFd::operator=(OwnedFd&& other) noexcept {
  const int old = std::exchange(fd_, other.release());
  if (old >= 0) close(old);
  return *this;
}

OwnedFd::~OwnedFd() {
  if (fd_ >= 0) close(fd_);
}

int OwnedFd::release() { return std::exchange(fd_, -1); }

}  // namespace obby::loopback
