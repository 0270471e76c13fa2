// What the bridge answers, whatever carries it: HTTP or lines on standard output.
#pragma once

#include <string>

#include "base/result.h"
#include "loopback/reply.h"

namespace obby::bridge {

using loopback::Reply;

// `{"error":"what is wrong","cure":"what to do"}`, with the input's place and path where the error
// has them.
Reply refuse(int status, const Error& error);
inline Reply refuse(int status, std::string message, std::string cure) {
  return refuse(status, makeError(std::move(message), std::move(cure)));
}

}  // namespace obby::bridge
