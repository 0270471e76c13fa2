// What a server answers to one request.
#pragma once

#include <string>

namespace obby::loopback {

struct Reply {
  int status = 200;                       // as of HTTP
  std::string body;                       // JSON, unless `type` says otherwise
  std::string type = "application/json";  // content type
};

// "Not Found"; an unknown status gives "Error".
const char* reason(int status);

}  // namespace obby::loopback
