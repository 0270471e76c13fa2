// Requests to the bridge are either refused or well-formed and authorised. The first byte selects
// what the rest is. h: the head of a request (method, address, then `Name: value` lines). j: the
// order of a job. s: a line of standard input. r: a record to be sent in messages.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "bridge/messages.h"
#include "bridge/order.h"
#include "bridge/request.h"
#include "bridge/stdio_request.h"
#include "head_lines.h"
#include "io/json_codec.h"
#include "io/json_tree.h"
#include "io/text.h"

namespace {

using namespace obby;

void require(bool holds) {
  if (!holds) std::abort();
}

bridge::RequestHead headOf(std::string_view text) {
  bridge::RequestHead head;
  fuzz::readHead(text, head, [&](std::string_view name, std::string_view value) {
    if (name == "Authorization") head.authorization = value;
    if (name == "Content-Type") head.contentType = value;
    if (name == "Content-Encoding") head.encoding = value;
    if (name == "Upgrade") head.upgrade = true;
    if (name == "Upgrade" && value == "websocket") head.webSocket = true;
    if (name == "Sec-WebSocket-Version") head.webSocketVersion = value;
    if (name == "Sec-WebSocket-Key") head.webSocketKey = value;
  });
  return head;
}

void checkHead(std::string_view text) {
  const bridge::RequestHead head = headOf(text);
  const bridge::Access access{34990, true,
                              [](std::string_view token) { return token == "right" ? 0 : -1; }};
  const auto checked = bridge::checkRequest(head, access);
  const auto* call = std::get_if<bridge::Call>(&checked);
  if (!call) return require(std::get<bridge::Reply>(checked).status >= 400);
  require(head.host && !head.origin && !head.fetchSite);
  const bool open =
      call->endpoint == bridge::Endpoint::info || call->endpoint == bridge::Endpoint::pair;
  require(open || head.authorization.value_or("").ends_with("right"));
  require((head.method == "POST") == (call->content != bridge::Content::none));
  require(call->id.empty() || bridge::isJobId(call->id) || bridge::isLevelId(call->id));
}

void checkOrder(std::string_view text) {
  const auto order = bridge::parseOrder(text, bridge::Limits());
  if (!order) return;
  for (const std::string& argument : order->arguments) {
    require(argument.starts_with("--") && argument.find_first_of(" \n/") == std::string::npos);
  }
  for (const std::string& record : order->records) {
    require(record.find('\n') == std::string::npos && bool(io::recordFromJson(record)));
  }
}

void checkLine(std::string_view text) {
  const auto request = bridge::parseStdioRequest(text);
  const auto* refusal = std::get_if<bridge::Reply>(&request.call);
  const std::string answer =
      bridge::stdioReply(request.id, refusal ? *refusal : bridge::Reply{200, "{}"});
  require(answer.find('\n') == std::string::npos && bool(io::JsonTree::parse(answer)));
}

void checkRecord(std::string_view text) {
  if (!io::isUtf8(text) || !io::JsonTree::parse(text)) return;
  for (const std::string& message : bridge::recordMessages("j1", text, 1024)) {
    require(message.size() <= 1024 && bool(io::JsonTree::parse(message)));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0]) {
    case 'h': checkHead(rest); break;
    case 'j': checkOrder(rest); break;
    case 's': checkLine(rest); break;
    case 'r': checkRecord(rest); break;
    default: break;
  }
  return 0;
}
