// What the bridge answers, whatever carries it: HTTP or lines on standard output.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::bridge {

struct Reply {
  int status = 200;                       // as of HTTP
  std::string body;                       // JSON, or records where `type` says so
  std::string type = "application/json";  // content type
};

// `{"error":"what is wrong","cure":"what to do"}`, with the input's place and path where the error
// has them.
Reply refuse(int status, const Error& error);
inline Reply refuse(int status, std::string message, std::string cure) {
  return refuse(status, makeError(std::move(message), std::move(cure)));
}

// "Not Found"; an unknown status gives "Error".
const char* reason(int status);

}  // namespace obby::bridge
