#include "bridge/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/spelling.h"
#include "io/text.h"
#include "loopback/sender.h"
#include "loopback/target.h"

namespace obby::bridge {
namespace {

constexpr uint64_t kMaxCursor = (uint64_t(1) << 53) - 1;  // the largest exact whole number in JSON
constexpr uint64_t kMaxWait = 3600;                       // the service waits less (limits.h)
constexpr size_t kMaxTarget = 512;

bool allOf(std::string_view text, std::string_view allowed) {
  return text.find_first_not_of(allowed) == std::string_view::npos;
}

// --- sender

std::optional<Reply> checkSender(const RequestHead& head, const Access& access) {
  if (!head.host || !loopback::hostAllowed(*head.host, access.port)) {
    return refuse(421, "the Host header does not name this bridge",
                  fmt::format("use http://127.0.0.1:{}", access.port));
  }
  // Programs send neither header; a page in a browser cannot leave them out.
  if (head.origin || head.fetchSite) {
    return refuse(403, "web pages may not use the bridge", "connect from a plugin or a program");
  }
  return {};
}

// Returns the token of "Bearer TOKEN", or nothing if the header has another form.
std::optional<std::string_view> bearer(std::string_view header) {
  constexpr std::string_view kScheme = "bearer ";
  if (lower(header.substr(0, kScheme.size())) != kScheme) return {};
  return header.substr(kScheme.size());
}

std::optional<Reply> checkToken(const RequestHead& head, const Access& access, Call& call) {
  if (!access.needToken) {
    call.client = 0;
    return {};
  }
  const bool open = call.endpoint == Endpoint::info || call.endpoint == Endpoint::pair;
  if (!head.authorization && open) return {};
  const auto token = head.authorization ? bearer(*head.authorization) : std::nullopt;
  call.client = token ? access.clientOf(*token) : -1;
  if (call.client >= 0) return {};
  return refuse(401, head.authorization ? "unknown token" : "a token is required",
                "pair: start obby-bridge --pair and send its code to /v1/pair");
}

// --- route

struct Route {
  const char* method;
  const char* path;  // a trailing * stands for an id
  Endpoint endpoint;
  std::array<std::string_view, 3> parameters;  // unused ones are empty
};

constexpr Route kRoutes[] = {
    {"GET", "/v1/info", Endpoint::info, {}},
    {"POST", "/v1/pair", Endpoint::pair, {}},
    {"POST", "/v1/levels", Endpoint::putLevel, {}},
    {"GET", "/v1/levels/*", Endpoint::getLevel, {"parts"}},
    {"POST", "/v1/jobs", Endpoint::putJob, {}},
    {"GET", "/v1/jobs/*", Endpoint::getJob, {"cursor", "session", "wait"}},
    {"DELETE", "/v1/jobs/*", Endpoint::cancelJob, {}},
    {"GET", "/v1/events", Endpoint::events, {"cursor", "session"}},
};

bool fits(const Route& row, std::string_view path, std::string& id) {
  const std::string_view pattern = row.path;
  if (pattern.back() != '*') return path == pattern;
  const std::string_view prefix = pattern.substr(0, pattern.size() - 1);
  if (path.substr(0, prefix.size()) != prefix) return false;
  id = path.substr(prefix.size());
  return row.endpoint == Endpoint::getLevel ? isLevelId(id) : isJobId(id);
}

bool setParameter(Call& call, std::string_view name, std::string_view value) {
  if (name == "session") {
    call.session = value;
    return value.size() <= 64 && allOf(lower(value), "0123456789abcdef");
  }
  if (name == "parts") {
    call.moving = true;
    return value == "moving";
  }
  const auto number = loopback::wholeNumber(value, name == "wait" ? kMaxWait : kMaxCursor);
  if (!number) return false;
  if (name == "wait") {
    call.wait = double(*number);
  } else {
    call.cursor = *number;
  }
  return true;
}

std::optional<Reply> readParameters(const std::vector<loopback::Parameter>& given, const Route& row,
                                    Call& call) {
  std::vector<std::string_view> seen;
  for (const auto& [name, value, text] : given) {
    const auto& names = row.parameters;
    const bool known = !name.empty() && std::find(names.begin(), names.end(), name) != names.end();
    const bool twice = std::find(seen.begin(), seen.end(), name) != seen.end();
    if (!known || twice || !setParameter(call, name, value)) {
      return refuse(400, "unknown parameter or value: " + io::quoted(text),
                    "cursor and wait are whole numbers, session comes from /v1/info, parts can "
                    "only be moving");
    }
    seen.push_back(name);
  }
  return {};
}

// --- handshake and content

std::optional<Reply> checkHandshake(const RequestHead& head, const Call& call) {
  if (call.endpoint != Endpoint::events) {
    if (!head.upgrade) return {};
    return refuse(400, "only /v1/events is a WebSocket", "leave out the Upgrade header");
  }
  if (head.webSocket && head.webSocketVersion == "13" && head.webSocketKey) return {};
  return refuse(426, "/v1/events is a WebSocket of version 13",
                "open it as one, or poll /v1/jobs/ID?cursor=N&wait=20");
}

std::optional<Content> contentOf(std::string_view type) {
  const std::string name = lower(type.substr(0, type.find_first_of("; ")));
  if (name == "application/json") return Content::json;
  if (name == "application/x-ndjson") return Content::records;
  if (name == "application/octet-stream") return Content::bytes;
  return {};
}

std::optional<Reply> checkContent(const RequestHead& head, Call& call) {
  if (head.method != "POST") return {};
  const bool level = call.endpoint == Endpoint::putLevel;
  const auto content = head.contentType ? contentOf(*head.contentType) : std::nullopt;
  const bool right = content && (*content == Content::json) != level;
  if (!right) {
    return refuse(415, "this content type is not accepted at this address",
                  level ? "send a place as application/octet-stream, records as "
                          "application/x-ndjson"
                        : "send application/json");
  }
  call.content = *content;
  const std::string encoding = lower(head.encoding.value_or("identity"));
  const bool stranger = call.endpoint == Endpoint::pair;  // nothing is inflated without a token
  call.gzip = encoding == "gzip" && !stranger;
  if (call.gzip || encoding == "identity") return {};
  return refuse(415, "this content encoding is not accepted",
                stranger ? "send it uncompressed" : "send it uncompressed or as gzip");
}

}  // namespace

bool isLevelId(std::string_view text) {
  return text.size() == 32 && allOf(text, "0123456789abcdef");
}

bool isJobId(std::string_view text) {
  return text.size() >= 2 && text.size() <= 16 && text[0] == 'j' &&
         allOf(text.substr(1), "0123456789");
}

std::variant<Call, Reply> route(std::string_view method, std::string_view target) {
  if (target.size() > kMaxTarget || target.empty() || target[0] != '/') {
    return refuse(400, "expected a path such as /v1/info", "see docs/bridge.md");
  }
  const auto [path, parameters] = loopback::targetOf(target);
  bool found = false;
  for (const Route& row : kRoutes) {
    Call call;
    if (!fits(row, path, call.id)) continue;
    found = true;
    if (method != row.method) continue;
    call.endpoint = row.endpoint;
    if (auto wrong = readParameters(parameters, row, call)) return *std::move(wrong);
    return call;
  }
  if (found) return refuse(405, "this method is not allowed at this address", "see docs/bridge.md");
  return refuse(404, "there is nothing at this address", "see docs/bridge.md");
}

std::variant<Call, Reply> checkRequest(const RequestHead& head, const Access& access) {
  if (auto wrong = checkSender(head, access)) return *std::move(wrong);
  std::variant<Call, Reply> routed = route(head.method, head.target);
  Call stranger;  // needs a token, so that clients without one learn nothing
  stranger.endpoint = Endpoint::events;
  Call* call = std::get_if<Call>(&routed);
  if (auto wrong = checkToken(head, access, call ? *call : stranger)) return *std::move(wrong);
  if (!call) return routed;
  if (auto wrong = checkHandshake(head, *call)) return *std::move(wrong);
  if (auto wrong = checkContent(head, *call)) return *std::move(wrong);
  return routed;
}

}  // namespace obby::bridge
