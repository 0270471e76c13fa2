// Checks a request and decodes what it asks for. Everything here is decided from the head alone,
// before a body is read or a WebSocket is accepted.
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

// The head of a request as received. The caller owns the texts.
struct RequestHead : loopback::Head {
  std::optional<std::string_view> authorization, contentType, encoding;
  bool upgrade = false;                              // has an Upgrade header
  bool webSocket = false;                            // the Upgrade header asks for a WebSocket
  std::optional<std::string_view> webSocketVersion;  // "13"
  std::optional<std::string_view> webSocketKey;
};

enum class Endpoint { info, pair, putLevel, getLevel, putJob, getJob, cancelJob, events };

enum class Content { none, json, records, bytes };

// A request that passed all checks.
struct Call {
  Endpoint endpoint = Endpoint::info;
  std::string id;                  // id of the level or job; well-formed, perhaps unknown
  std::optional<uint64_t> cursor;  // number of the last message that the client has
  std::string session;             // session of the cursor; empty if not given
  double wait = 0;                 // seconds
  bool moving = false;             // requests only the parts of a level that move (bridge/moving.h)
  Content content = Content::none;
  bool gzip = false;
  int client = -1;  // owner of the token; -1 if none was sent, which only info and pair allow
};

struct Access {
  uint16_t port = 0;      // the port listened on, which Host must name
  bool needToken = true;  // if false (--no-token), all requests count as one client's
  // Returns the client of a token, or -1 for none, in constant time.
  std::function<int(std::string_view)> clientOf;
};

// Checks Host, Origin, token, route, method, WebSocket handshake, content type and encoding, in
// this order. The Reply says what is wrong and what to do.
std::variant<Call, Reply> checkRequest(const RequestHead& head, const Access& access);

// Checks only the route and its parameters, for a known sender.
std::variant<Call, Reply> route(std::string_view method, std::string_view target);

// Return true for 32 hexadecimal digits, and for "j" with up to 15 digits.
bool isLevelId(std::string_view text);
bool isJobId(std::string_view text);

}  // namespace obby::bridge
