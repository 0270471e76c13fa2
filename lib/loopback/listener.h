// A socket that this machine alone can reach.
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

// Port 0 takes any free one; no other one is tried where `port` is taken. The error names --port.
Result<Listener> listenOn(uint16_t port);

}  // namespace obby::loopback
