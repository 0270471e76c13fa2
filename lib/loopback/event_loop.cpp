#include "loopback/event_loop.h"

namespace obby::loopback {
namespace {

constexpr auto kLook = 50 * kj::MILLISECONDS;

}  // namespace

kj::Promise<void> EventLoop::untilSet(const std::atomic<bool>& stop) {
  if (stop) return kj::READY_NOW;
  return io.provider->getTimer().afterDelay(kLook).then([this, &stop] { return untilSet(stop); });
}

}  // namespace obby::loopback
