// Sends messages to a client over its WebSocket, from a cursor on, until either side ends it.
#pragma once

#include <kj/compat/http.h>

#include <memory>

#include "bridge/client.h"
#include "bridge/service.h"

namespace obby::bridge {

// Close codes. Those above 4000 are the bridge's own.
enum CloseCode : uint16_t { kNormal = 1000, kGoingAway = 1001, kSilent = 4408, kReload = 4410 };

// Ends with the WebSocket, without an exception. The client has all messages up to `cursor`, and
// all later ones must still be kept.
kj::Promise<void> sendEvents(kj::Own<kj::WebSocket> socket, std::shared_ptr<Client> client,
                             Service& service, uint64_t cursor);

}  // namespace obby::bridge
