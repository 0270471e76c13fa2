#include "loopback/listener.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstring>

namespace obby::loopback {
namespace {

constexpr int kBacklog = 64;

Error portError(uint16_t port, const char* what) {
  const bool busy = errno == EADDRINUSE;
  return Error{
      {},
      {},
      fmt::format("--port {}", port),
      fmt::format("cannot {}: {}", what, std::strerror(errno)),
      busy ? "another program may be using this port; choose another port with --port" : ""};
}

}  // namespace

Result<Listener> listenOn(uint16_t port) {
  OwnedFd fd(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (fd.get() < 0) return portError(port, "create a socket");
  const int on = 1;  // makes the port free as soon as its server has ended
  setsockopt(fd.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* general = reinterpret_cast<sockaddr*>(&address);
  if (bind(fd.get(), general, size) != 0 || listen(fd.get(), kBacklog) != 0) {
    return portError(port, "listen");
  }
  if (getsockname(fd.get(), general, &size) != 0) return portError(port, "listen");
  return Listener{std::move(fd), ntohs(address.sin_port)};
}

}  // namespace obby::loopback
