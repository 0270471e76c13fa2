#include "view/live.h"

#include <thread>

#include "loopback/event_loop.h"
#include "view/live_data.h"
#include "view/live_server.h"

namespace obby::view {
namespace {

constexpr auto kLook = 20 * kj::MILLISECONDS;
constexpr auto kMinBetween = 200 * kj::MILLISECONDS;  // between revisions
constexpr double kQuietSeconds = 2;                   // after which a page counts as closed

// Copies changes into the data at a limited rate.
class Taking {
 public:
  Taking(GrowingReport& report, LiveData& data, kj::Timer& timer)
      : report_(report), data_(data), timer_(timer), next_(timer.now()) {}

  // Ends only by an exception.
  kj::Promise<void> run() {
    const auto take = [this](const Report& report, StreamState state) {
      data_.take(report, state);
    };
    if (timer_.now() >= next_ && report_.look(take)) next_ = timer_.now() + kMinBetween;
    return timer_.afterDelay(kLook).then([this] { return run(); });
  }

 private:
  GrowingReport& report_;
  LiveData& data_;
  kj::Timer& timer_;
  kj::TimePoint next_;
};

kj::Promise<void> untilLeft(const GrowingReport& report, const LiveServer& server,
                            kj::Timer& timer) {
  if (!report.open() && server.quietFor() >= kQuietSeconds) return kj::READY_NOW;
  return timer.afterDelay(kLook).then([&] { return untilLeft(report, server, timer); });
}

// Reads the stream until this object is destroyed.
class ReadingThread {
 public:
  ReadingThread(GrowingReport& report, const LiveReader& read)
      : report_(report), thread_([this, &read] { read(halt_); }) {}
  ~ReadingThread() {
    halt_ = true;
    report_.close();
    thread_.join();
  }

 private:
  GrowingReport& report_;
  std::atomic<bool> halt_{false};
  std::thread thread_;
};

}  // namespace

Status serveLive(GrowingReport& report, const LiveReader& read, const LiveOptions& options,
                 const std::atomic<bool>& stop, const LiveReports& reports) {
  OBBY_ASSIGN(std::string page, livePage());
  OBBY_ASSIGN(loopback::Listener listener, loopback::listenOn(options.port));
  loopback::EventLoop events(reports.note);
  kj::Timer& timer = events.io.provider->getTimer();
  LiveData data(options.page);
  LiveServer server(events.io, std::move(listener), data, std::move(page), reports.note);
  reports.address(server.address());
  const ReadingThread reading(report, read);
  Taking taking(report, data, timer);
  try {
    auto work = server.run().exclusiveJoin(taking.run()).exclusiveJoin(events.untilSet(stop));
    if (options.endWithPages) work = work.exclusiveJoin(untilLeft(report, server, timer));
    work.wait(events.io.waitScope);
  } catch (const kj::Exception& e) {
    return makeError(e.getDescription().cStr());
  }
  return {};
}

}  // namespace obby::view
