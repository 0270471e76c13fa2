// A socket that only this machine can reach.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "loopback/owned_fd.h"

namespace obby::loopback {

// Listens on 127.0.0.1.
struct Listener {
  OwnedFd fd;
  uint16_t port = 0;
};

// Port 0 takes any free port. If `port` is taken, no other is tried. An error names --port.
Result<Listener> listenOn(uint16_t port);

}  // namespace obby::loopback
