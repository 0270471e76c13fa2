// Requests to a live page's server are refused unless they have the token and do not come from
// another page.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "head_lines.h"
#include "view/live_request.h"

namespace {

using namespace obby;

constexpr uint16_t kPort = 34990;
constexpr std::string_view kToken = "right";

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  view::LiveHead head;
  fuzz::readHead({reinterpret_cast<const char*>(data), size}, head,
                 [&](std::string_view name, std::string_view value) {
                   if (name == "Sec-Fetch-Mode") head.fetchMode = value;
                 });
  const auto checked = view::checkLiveRequest(head, kPort, kToken);
  const auto* call = std::get_if<view::LiveCall>(&checked);
  if (!call) {
    require(std::get<loopback::Reply>(checked).status >= 400);
    return 0;
  }
  require(head.method == "GET" && head.host && loopback::hostAllowed(*head.host, kPort));
  require(!head.origin || loopback::originIsOwn(*head.origin, kPort));
  require(head.target.find("token=" + std::string(kToken)) != std::string_view::npos);
  const bool foreign =
      head.fetchSite && *head.fetchSite != "same-origin" && *head.fetchSite != "none";
  require(!foreign || (call->route == view::LiveRoute::page && head.fetchMode == "navigate"));
  return 0;
}
