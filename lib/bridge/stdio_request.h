// A request as a line of JSON, for programs that can start the bridge themselves.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "bridge/request.h"

namespace obby::bridge {

struct StdioRequest {
  std::string id = "null";                   // JSON, returned with the reply
  std::variant<Call, Reply> call = Reply{};  // the call, or the reply that refuses the request
  std::string body;
};

// Parses `{"id":1,"method":"POST","path":"/v1/jobs","body":{...}}`. Instead of `body`, `text` holds
// records as they are, and `base64` any bytes.
StdioRequest parseStdioRequest(std::string_view line);

// Returns `{"id":1,"status":200,"body":{...}}`, with records as `text`.
std::string stdioReply(const std::string& id, const Reply& reply);

}  // namespace obby::bridge
