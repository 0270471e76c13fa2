// Accepts or refuses requests to the live page's server, by their head alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "loopback/reply.h"
#include "loopback/sender.h"

namespace obby::view {

// The request's head. The caller owns its texts.
struct LiveHead : loopback::Head {
  std::optional<std::string_view> fetchMode;  // Sec-Fetch-Mode
};

enum class LiveRoute { page, data, events };

struct LiveCall {
  LiveRoute route = LiveRoute::page;
  uint64_t from = 0;  // data: the revision of the page
};

// Checks host, sender, token, address, method and parameters, in this order. Unauthorised clients
// learn only that they are refused.
std::variant<LiveCall, loopback::Reply> checkLiveRequest(const LiveHead& head, uint16_t port,
                                                         std::string_view token);

}  // namespace obby::view
