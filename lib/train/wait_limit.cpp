#include "train/wait_limit.h"

namespace obby::train {

namespace {

constexpr std::chrono::milliseconds kLook{20};

}  // namespace

WaitLimit::WaitLimit(const std::atomic<bool>& interrupted, double seconds, double more)
    : interrupted_(interrupted),
      limit_(seconds),
      seconds_(seconds + more),
      watcher_([this] { watch(); }) {}

WaitLimit::~WaitLimit() {
  {
    const std::lock_guard hold(lock_);
    over_ = true;
  }
  wake_.notify_all();
  watcher_.join();
}

// Signal handlers can set a flag but not notify, so the flag is polled.
void WaitLimit::watch() {
  std::unique_lock hold(lock_);
  while (!over_) {
    if (interrupted_) stop_ = true;
    const std::chrono::duration<double> passed = Clock::now() - since_;
    const double over = begun_ ? passed.count() - limit_ : -1;
    if (interrupted_ || over >= 0) late_ = true;
    if (interrupted_ || over >= kForFiles) lost_ = true;
    if (reading_ && !stop_ && passed.count() >= seconds_) {
      up_ = true;
      stop_ = true;
    }
    wake_.wait_for(hold, kLook);
  }
}

void WaitLimit::read(bool now) {
  const std::lock_guard hold(lock_);
  reading_ = now;
  if (!begun_) since_ = Clock::now();
}

Result<std::optional<io::Record>> WaitLimit::next(io::RecordSource& source) {
  read(true);
  auto record = source.next();
  // The signal may also have reached the process that writes the stream. A truncated stream is then
  // no error.
  if (interrupted_) {
    stop_ = true;
    if (!record) record = std::optional<io::Record>();
  }
  read(false);
  return record;
}

void WaitLimit::begin() {
  const std::lock_guard hold(lock_);
  begun_ = true;
  late_ = lost_ = false;
  since_ = Clock::now();
}

}  // namespace obby::train
