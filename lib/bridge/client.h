// One client: the messages to it, and the time of its last request.
#pragma once

#include <kj/async.h>
#include <kj/vector.h>

#include <functional>
#include <string>

#include "bridge/messages.h"

namespace obby::bridge {

class Client {
 public:
  Client(int number, uint64_t ringBytes, uint64_t unsentBytes = 0)
      : number_(number), ring_(ringBytes, unsentBytes) {}

  int number() const { return number_; }
  const Ring& ring() const { return ring_; }

  // Adds a message for the client, and wakes its waiters.
  void tell(uint64_t job, std::string_view object) {
    if (beforeLoss && ring_.halfFull()) beforeLoss();
    ring_.push(job, object);
    wake();
  }
  // Notes that the messages up to `cursor` have gone to a carrier that takes all messages in order.
  // Later messages are kept longer, until the carrier takes them.
  void hold(uint64_t cursor) { ring_.hold(cursor); }
  // Notes that the carrier no longer takes messages.
  void release() { ring_.release(); }
  // Resolves when a new message arrives, or another state changes.
  kj::Promise<void> whenWoken() {
    auto waiting = kj::newPromiseAndFulfiller<void>();
    waiters_.add(kj::mv(waiting.fulfiller));
    return kj::mv(waiting.promise);
  }
  void wake() {
    auto waiters = kj::mv(waiters_);
    waiters_ = {};
    for (auto& waiter : waiters) waiter->fulfill();
  }

  double lastSeen = 0;       // seconds of Loop::now()
  bool mayBeSilent = false;  // the carrier reports a disconnect, so silence means nothing
  bool socketOpen = false;   // a WebSocket is open; a client has at most one
  bool dropSocket = false;   // asks that WebSocket to close
  bool ending = false;       // asks it to close once all messages have been sent

  // Called before messages are lost, if the carrier can take all of them at any time. One record
  // can need more messages than are kept.
  std::function<void()> beforeLoss;

 private:
  int number_;
  Ring ring_;
  kj::Vector<kj::Own<kj::PromiseFulfiller<void>>> waiters_;
};

}  // namespace obby::bridge
