// The body of a request, read as far as the limits allow.
#pragma once

#include <kj/async-io.h>

#include <string>
#include <variant>

#include "bridge/limits.h"
#include "bridge/reply.h"
#include "bridge/request.h"

namespace obby::bridge {

// The bytes, inflated if they came as gzip; or why they are refused: too many for what is asked,
// too slow, no gzip. A client that goes away is a kj exception.
kj::Promise<std::variant<std::string, Reply>> readBody(kj::AsyncInputStream& body, const Call& call,
                                                       const Limits& limits, kj::Timer& timer);

}  // namespace obby::bridge
