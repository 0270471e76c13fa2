// Whether a request may come in, and what it asks. Everything here is decided from the head alone,
// before any body is read or a WebSocket is accepted.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "bridge/reply.h"
#include "loopback/sender.h"

namespace obby::bridge {

// The head of a request as it came; texts belong to the caller.
struct RequestHead : loopback::Head {
  std::optional<std::string_view> authorization, contentType, encoding;
  bool upgrade = false;                              // has an Upgrade header
  bool webSocket = false;                            // and it asks for a WebSocket
  std::optional<std::string_view> webSocketVersion;  // "13"
  std::optional<std::string_view> webSocketKey;
};

enum class Endpoint { info, pair, putLevel, getLevel, putJob, getJob, cancelJob, events };

enum class Content { none, json, records, bytes };

// A request that passed all checks.
struct Call {
  Endpoint endpoint = Endpoint::info;
  std::string id;                  // of the level or job; well-formed, perhaps unknown
  std::optional<uint64_t> cursor;  // number of the last message that the client has
  std::string session;             // that the cursor belongs to; empty: not said
  double wait = 0;                 // seconds
  bool moving = false;             // of a level's parts only those that move (bridge/moving.h)
  Content content = Content::none;
  bool gzip = false;
  int client = -1;  // whose token it was; -1: none was sent, which only info and pair allow
};

struct Access {
  uint16_t port = 0;      // that is listened on: Host must name it
  bool needToken = true;  // --no-token: every request is the one client's
  // Which client has this token; -1: nobody. In constant time.
  std::function<int(std::string_view)> clientOf;
};

// Host, Origin, token, route, method, WebSocket handshake, content type and encoding, in this
// order. The Reply says what is wrong and what to do.
std::variant<Call, Reply> checkRequest(const RequestHead& head, const Access& access);

// The route and its parameters alone: all there is to check where the sender is known.
std::variant<Call, Reply> route(std::string_view method, std::string_view target);

// 32 hexadecimal digits; "j" and up to 15 digits.
bool isLevelId(std::string_view text);
bool isJobId(std::string_view text);

}  // namespace obby::bridge
