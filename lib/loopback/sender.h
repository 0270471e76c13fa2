// Checks of a request's sender by its head. They detect pages of other sites, and host names that a
// site has pointed at this machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace obby::loopback {

// The head of a request as received. The caller owns the texts.
struct Head {
  std::string_view method, target;  // "GET", "/path?name=value"
  std::optional<std::string_view> host, origin, fetchSite;
};

// Returns true if a Host header names this machine's loopback with the server's port.
bool hostAllowed(std::string_view host, uint16_t port);

// Returns true if an Origin header is that of a page which this server has sent.
bool originIsOwn(std::string_view origin, uint16_t port);

}  // namespace obby::loopback
