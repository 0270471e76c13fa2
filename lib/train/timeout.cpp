#include "train/timeout.h"

namespace obby::train {

namespace {

constexpr std::chrono::milliseconds kLook{20};

}  // namespace

Timeout::Timeout(const std::atomic<bool>& interrupted, double seconds, double grace)
    : interrupted_(interrupted),
      workSeconds_(seconds),
      recordSeconds_(seconds + grace),
      watcher_([this] { watch(); }) {}

Timeout::~Timeout() {
  {
    const std::lock_guard hold(lock_);
    over_ = true;
  }
  wake_.notify_all();
  watcher_.join();
}

// Signal handlers can set a flag but not notify, so the flag is polled.
void Timeout::watch() {
  std::unique_lock hold(lock_);
  while (!over_) {
    const double passed = std::chrono::duration<double>(Clock::now() - since_).count();
    if (interrupted_) stop_ = true;
    if (interrupted_ || (begun_ && passed >= workSeconds_)) late_ = true;
    if (reading_ && !stop_ && passed >= recordSeconds_) {
      expired_ = true;
      stop_ = true;
    }
    wake_.wait_for(hold, kLook);
  }
}

void Timeout::setReading(bool now) {
  const std::lock_guard hold(lock_);
  reading_ = now;
  if (!begun_) since_ = Clock::now();
}

Result<std::optional<io::Record>> Timeout::next(io::RecordSource& source) {
  setReading(true);
  auto record = source.next();
  // The signal may also have reached the process that writes the stream. A truncated stream is then
  // no error.
  if (interrupted_) {
    stop_ = true;
    if (!record) record = std::optional<io::Record>();
  }
  setReading(false);
  return record;
}

void Timeout::begin() {
  const std::lock_guard hold(lock_);
  begun_ = true;
  since_ = Clock::now();
}

}  // namespace obby::train
