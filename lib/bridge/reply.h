// Replies of the bridge, independent of the carrier: HTTP or lines on standard output.
#pragma once

#include <string>

#include "base/result.h"
#include "loopback/reply.h"

namespace obby::bridge {

using loopback::Reply;

// Returns `{"error":"what is wrong","cure":"what to do"}`, with the input's place and path if the
// error has them.
Reply refuse(int status, const Error& error);
inline Reply refuse(int status, std::string message, std::string cure) {
  return refuse(status, makeError(std::move(message), std::move(cure)));
}

}  // namespace obby::bridge
