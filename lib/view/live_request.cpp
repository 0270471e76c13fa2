#include "view/live_request.h"

#include <algorithm>

#include "loopback/secrets.h"
#include "loopback/target.h"

namespace obby::view {
namespace {

using loopback::Reply;

constexpr uint64_t kMaxRevision = (uint64_t(1) << 53) - 1;  // largest exact integer of a JSON
                                                            // number
constexpr size_t kMaxTarget = 512;

struct Route {
  std::string_view path;
  LiveRoute route;
};
constexpr Route kRoutes[] = {
    {"/", LiveRoute::page}, {"/data", LiveRoute::data}, {"/events", LiveRoute::events}};

Reply refuse(int status, const char* why) { return {status, why, "text/plain; charset=utf-8"}; }

// Another site's page may link here, but may neither read nor embed anything.
bool foreign(const LiveHead& head, std::string_view path, uint16_t port) {
  if (head.origin && !loopback::originIsOwn(*head.origin, port)) return true;
  if (!head.fetchSite || *head.fetchSite == "same-origin" || *head.fetchSite == "none") {
    return false;
  }
  return path != "/" || head.fetchMode != "navigate";
}

// Returns a parameter's value, or nothing if it is missing or repeated.
std::optional<std::string_view> valueOf(const loopback::Target& target, std::string_view name) {
  std::optional<std::string_view> found;
  for (const loopback::Parameter& parameter : target.parameters) {
    if (parameter.name != name) continue;
    if (found) return {};
    found = parameter.value;
  }
  return found;
}

}  // namespace

std::variant<LiveCall, Reply> checkLiveRequest(const LiveHead& head, uint16_t port,
                                               std::string_view token) {
  if (!head.host || !loopback::hostAllowed(*head.host, port)) {
    return refuse(
        421, "The Host header does not name this server. Use the address that obby-view printed.");
  }
  const loopback::Target target = loopback::targetOf(head.target.substr(0, kMaxTarget));
  if (foreign(head, target.path, port))
    return refuse(403, "Requests from other pages are not allowed.");
  const auto given = valueOf(target, "token");
  if (!given || !loopback::equalInConstantTime(*given, token)) {
    return refuse(403, "Open the address that obby-view printed, with its token.");
  }
  const auto row = std::ranges::find(kRoutes, target.path, &Route::path);
  if (row == std::end(kRoutes)) return refuse(404, "There is nothing at this address.");
  if (head.method != "GET") return refuse(405, "Only GET is allowed.");
  LiveCall call{row->route};
  const auto revision = call.route == LiveRoute::data ? valueOf(target, "from") : std::nullopt;
  const auto from = loopback::wholeNumber(revision.value_or("0"), kMaxRevision);
  if (!from || target.parameters.size() != (revision ? 2u : 1u)) {
    return refuse(400, "The parameters are invalid.");
  }
  call.from = *from;
  return call;
}

}  // namespace obby::view
