// Reads the body of a request within the limits.
#pragma once

#include <kj/async-io.h>

#include <string>
#include <variant>

#include "bridge/limits.h"
#include "bridge/reply.h"
#include "bridge/request.h"

namespace obby::bridge {

// Returns the bytes, inflated if they were sent as gzip, or a reply that refuses them: too many for
// this endpoint, too slow, or not gzip. Throws a kj exception if the client goes away.
kj::Promise<std::variant<std::string, Reply>> readBody(kj::AsyncInputStream& body, const Call& call,
                                                       const Limits& limits, kj::Timer& timer);

}  // namespace obby::bridge
