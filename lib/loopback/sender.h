// Who sends a request, as far as its head tells: pages of other sites, and names that a site has
// pointed at this machine, give themselves away here.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace obby::loopback {

// What the head of every request tells, as it came; texts belong to the caller.
struct Head {
  std::string_view method, target;  // "GET", "/path?name=value"
  std::optional<std::string_view> host, origin, fetchSite;
};

// Whether a Host header names this machine's loopback with the port that is listened on.
bool hostAllowed(std::string_view host, uint16_t port);

// Whether an Origin header is that of a page which this server itself has sent.
bool originIsOwn(std::string_view origin, uint16_t port);

}  // namespace obby::loopback
