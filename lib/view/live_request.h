// Whether a request to the live page's server comes in, decided from its head alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "loopback/reply.h"
#include "loopback/sender.h"

namespace obby::view {

// The head as it came; texts belong to the caller.
struct LiveHead : loopback::Head {
  std::optional<std::string_view> fetchMode;  // as browsers say it
};

enum class LiveRoute { page, data, events };

struct LiveCall {
  LiveRoute route = LiveRoute::page;
  uint64_t from = 0;  // data: the revision that the page has
};

// Host, sender, token, address, method, parameters, in this order. Strangers learn nothing beyond
// that they are refused.
std::variant<LiveCall, loopback::Reply> checkLiveRequest(const LiveHead& head, uint16_t port,
                                                         std::string_view token);

}  // namespace obby::view
