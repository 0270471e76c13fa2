// One client: what it is told, and when it last spoke.
#pragma once

#include <kj/async.h>
#include <kj/vector.h>

#include <functional>
#include <string>

#include "bridge/ring.h"

namespace obby::bridge {

class Client {
 public:
  Client(int number, uint64_t ringBytes, uint64_t unsentBytes = 0)
      : number_(number), ring_(ringBytes, unsentBytes) {}

  int number() const { return number_; }
  const Ring& ring() const { return ring_; }

  // A message to the client; whoever waits for one is woken.
  void tell(uint64_t job, const std::string& members) {
    if (beforeLoss && ring_.halfFull()) beforeLoss();
    ring_.push(job, members);
    wake();
  }
  // Those up to `cursor` have gone to a carrier that takes all in their order: what it has yet to
  // take is kept longer.
  void hold(uint64_t cursor) { ring_.hold(cursor); }
  // It takes no more.
  void release() { ring_.release(); }
  // When the next message is there, or something else is to be looked at.
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
  bool mayBeSilent = false;  // its carrier tells when it has gone: silence means nothing
  bool socketOpen = false;   // one WebSocket at a time
  bool dropSocket = false;   // asks that WebSocket to close
  bool ending = false;       // asks it to close once all messages have gone

  // Takes all messages that there are: of a carrier that can, whenever it is asked. One record can
  // be more of them than are kept.
  std::function<void()> beforeLoss;

 private:
  int number_;
  Ring ring_;
  kj::Vector<kj::Own<kj::PromiseFulfiller<void>>> waiters_;
};

}  // namespace obby::bridge
