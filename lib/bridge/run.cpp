#include "bridge/run.h"

#include <signal.h>

namespace obby::bridge {
namespace {

constexpr uint kFdFlags =
    kj::LowLevelAsyncIoProvider::TAKE_OWNERSHIP | kj::LowLevelAsyncIoProvider::ALREADY_CLOEXEC;

// Passes on the whole lines of `rest`.
void takeLines(std::string& rest, size_t searchFrom, const Run::OnLine& onLine) {
  size_t begin = 0;
  for (size_t end = rest.find('\n', searchFrom); end != std::string::npos;
       end = rest.find('\n', begin)) {
    onLine(std::string_view(rest).substr(begin, end - begin));
    begin = end + 1;
  }
  rest.erase(0, begin);
}

}  // namespace

double Loop::now() const {
  return double((timer.now() - kj::origin<kj::TimePoint>()) / kj::MILLISECONDS) / 1000;
}

Run::Run(Loop& loop, Process process, std::string input, OnLine onOutput, OnLine onError)
    : process_(std::move(process)),
      text_(std::move(input)),
      onOutput_(std::move(onOutput)),
      onError_(std::move(onError)),
      input_(loop.io.wrapOutputFd(process_.input.release(), kFdFlags)),
      output_(loop.io.wrapInputFd(process_.output.release(), kFdFlags)),
      errors_(loop.io.wrapInputFd(process_.errors.release(), kFdFlags)),
      exited_(loop.events, process_.exitFd(), kj::UnixEventPort::FdObserver::OBSERVE_READ) {}

kj::Promise<void> Run::feed() {
  // A program that ends before it has read everything is not an error here, because its exit status
  // shows the reason. write() throws at once if the program has already ended.
  return kj::evalNow([this] { return input_->write(text_.data(), text_.size()); })
      .catch_([](kj::Exception&&) {})
      .then([this] {
        input_ = nullptr;
        text_ = {};
      })
      .eagerlyEvaluate(nullptr);  // the program waits for the end of its input
}

kj::Promise<void> Run::lines(kj::AsyncInputStream& from, std::string& rest, const OnLine& onLine) {
  const bool out = &from == output_.get();
  char* buffer = out ? outBuffer_ : errBuffer_;
  const size_t size = out ? sizeof outBuffer_ : sizeof errBuffer_;
  return from.tryRead(buffer, 1, size)
      .then([this, &from, &rest, &onLine, buffer, out](size_t n) -> kj::Promise<void> {
        if (n == 0) {
          // A record without its newline is incomplete: its program was killed while writing.
          if (!out && !rest.empty()) onLine(rest);
          return kj::READY_NOW;
        }
        const size_t searchFrom = rest.size();
        rest.append(buffer, n);
        takeLines(rest, searchFrom, onLine);
        if (rest.size() > kMaxLine) signal(SIGKILL);
        return lines(from, rest, onLine);
      });
}

// A handler may fail when memory runs out. Without a reader for its output, the program would wait
// forever.
kj::Promise<void> Run::endingIt(kj::Promise<void> reading) {
  return reading
      .catch_([this](kj::Exception&& failure) {
        signal(SIGKILL);
        kj::throwFatalException(kj::mv(failure));
      })
      .eagerlyEvaluate(nullptr);  // Runs at once, not only when all streams have ended.
}

kj::Promise<Exit> Run::done() {
  // The streams and the program may end in any order. But once the program has ended, the rest of
  // its group must not hold its streams open.
  auto exit = exited_.whenBecomesReadable().then([this] { return process_.reap(); });
  auto streams = kj::heapArrayBuilder<kj::Promise<void>>(3);
  streams.add(feed());
  streams.add(endingIt(lines(*output_, outRest_, onOutput_)));
  streams.add(endingIt(lines(*errors_, errRest_, onError_)));
  return exit.then([all = kj::joinPromises(streams.finish()).eagerlyEvaluate(nullptr)](
                       Exit how) mutable { return all.then([how] { return how; }); });
}

}  // namespace obby::bridge
