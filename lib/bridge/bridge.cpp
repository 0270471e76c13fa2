#include "bridge/bridge.h"

#include <fmt/format.h>
#include <signal.h>

#include "bridge/http.h"
#include "bridge/stdio.h"
#include "loopback/event_loop.h"

namespace obby::bridge {
namespace {

constexpr auto kSweep = 1 * kj::SECONDS;
// Time for clients to read the remaining messages at the end.
constexpr auto kFarewell = 1 * kj::SECONDS;

// The event loop and the service on it.
class Host {
 public:
  Host(const Options& options, const Reports& reports, const std::atomic<bool>& stop)
      : events_(reports.note),
        loop_{*events_.io.lowLevelProvider, events_.io.unixEventPort,
              events_.io.provider->getTimer()},
        options_(options),
        stop_(stop) {
    signal(SIGCHLD, SIG_DFL);  // a parent may have left SIGCHLD ignored, and exits would be lost
  }

  Status open(bool needToken) {
    OBBY_ASSIGN(Programs programs, findPrograms(options_.solve));
    OBBY_ASSIGN(Store store, Store::open(options_.stateDir, options_.limits));
    Tokens tokens;
    if (needToken) {
      OBBY_ASSIGN(tokens, Tokens::open(store.tokensPath(), options_.limits.clients));
    }
    service_ = std::make_unique<Service>(loop_, options_.limits, std::move(programs),
                                         std::move(store), std::move(tokens), needToken);
    return {};
  }

  Service& service() { return *service_; }

  // Runs the event loop until `work` ends, `stop` is set, or no client has been seen for too long.
  // Then runs it until all jobs have ended, and `farewell`, which informs the clients.
  Status serve(kj::Promise<void> work, kj::Function<kj::Promise<void>()> farewell) {
    try {
      work.exclusiveJoin(events_.untilSet(stop_))
          .exclusiveJoin(untilIdle())
          .wait(events_.io.waitScope);
      service_->jobs().cancelAll(nullptr, "the bridge is shutting down");
      const auto max = uint64_t((options_.limits.stopSeconds + 1) * 1000) * kj::MILLISECONDS;
      service_->jobs()
          .whenIdle()
          .exclusiveJoin(loop_.timer.afterDelay(max))
          .then([&] { return farewell().exclusiveJoin(loop_.timer.afterDelay(kFarewell)); })
          .wait(events_.io.waitScope);
    } catch (const kj::Exception& e) {
      return makeError(e.getDescription().cStr());
    }
    return {};
  }

 private:
  kj::Promise<void> untilIdle() {
    service_->sweep();
    const double max = options_.idleSeconds;
    if (max > 0 && service_->quietFor() >= max) return kj::READY_NOW;
    return loop_.timer.afterDelay(kSweep).then([this] { return untilIdle(); });
  }

  loopback::EventLoop events_;
  Loop loop_;
  const Options& options_;
  const std::atomic<bool>& stop_;
  std::unique_ptr<Service> service_;
};

}  // namespace

Status serveHttp(const Options& options, const std::atomic<bool>& stop, const Reports& reports) {
  Host host(options, reports, stop);
  OBBY_RETURN_IF_ERROR(host.open(options.needToken));
  Service& service = host.service();
  if (options.needToken && !options.pair && !service.paired()) {
    return makeError("no client is paired yet, so no client could connect",
                     "start obby-bridge with --pair to show a pairing code");
  }
  OBBY_ASSIGN(loopback::Listener listener, loopback::listenOn(options.port));
  reports.say(fmt::format("listening on http://127.0.0.1:{}", listener.port));
  if (!options.needToken) {
    reports.warn("--no-token: any program of any user on this machine can use the bridge");
  } else if (options.pair) {
    reports.say(fmt::format("pairing code (valid for {} minutes): {}", int(Pairing::kSeconds) / 60,
                            service.offerPairing().shown()));
  }
  HttpFront front(service, std::move(listener), reports.note);
  return host.serve(front.run(), [&] {
    service.endEvents();
    return front.drain();
  });
}

Status serveStdio(const Options& options, const std::atomic<bool>& stop, const Reports& reports,
                  io::Sink output) {
  Host host(options, reports, stop);
  OBBY_RETURN_IF_ERROR(host.open(false));
  StdioFront front(host.service(), std::move(output));
  const Status served = host.serve(front.run(), [] { return kj::Promise<void>(kj::READY_NOW); });
  const Status finished = front.finish();
  return served ? finished : served;
}

}  // namespace obby::bridge
