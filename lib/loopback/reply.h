// The reply of a server to one request.
#pragma once

#include <string>

namespace obby::loopback {

struct Reply {
  int status = 200;                       // HTTP status
  std::string body;                       // JSON, unless `type` differs
  std::string type = "application/json";  // content type
};

// Returns the reason phrase of a status, such as "Not Found", or "Error" for an unknown one.
const char* reason(int status);

}  // namespace obby::loopback
