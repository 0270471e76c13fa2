#include "bridge/stdio.h"

#include <errno.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>

#include "bridge/stdio_request.h"

namespace obby::bridge {
namespace {

// The event loop can wait for pipes, sockets and terminals, but not for files.
bool canWait(int fd) {
  struct stat about {};
  if (fstat(fd, &about) != 0) return false;
  return S_ISFIFO(about.st_mode) || S_ISSOCK(about.st_mode) || isatty(fd) == 1;
}

}  // namespace

StdioFront::StdioFront(Service& service, io::Sink output)
    : service_(service),
      output_(std::move(output)),
      client_(service.client(0)),
      flags_(fcntl(STDIN_FILENO, F_GETFL)) {
  // A client that waits for a quiet program sends nothing, and owes no pong.
  client_->mayBeSilent = true;
  client_->beforeLoss = [this] { writeEvents(); };
  if (canWait(STDIN_FILENO)) input_ = service.loop().io.wrapInputFd(STDIN_FILENO);
  if (canWait(STDOUT_FILENO)) {
    using Observer = kj::UnixEventPort::FdObserver;
    reader_ = kj::heap<Observer>(service.loop().events, STDOUT_FILENO, Observer::OBSERVE_WRITE);
  }
}

StdioFront::~StdioFront() {
  client_->beforeLoss = nullptr;
  if (flags_ >= 0) fcntl(STDIN_FILENO, F_SETFL, flags_);
}

kj::Promise<void> StdioFront::run() {
  auto all = requests().then([this] { return service_.jobs().whenIdle(); });
  return all.exclusiveJoin(events()).exclusiveJoin(readerGone());
}

kj::Promise<size_t> StdioFront::readSome() {
  if (input_.get() != nullptr) return input_->tryRead(buffer_, 1, sizeof buffer_);
  ssize_t n = 0;
  while ((n = read(STDIN_FILENO, buffer_, sizeof buffer_)) < 0 && errno == EINTR) {
  }
  return size_t(std::max<ssize_t>(n, 0));
}

// Returns the line up to its newline at `end`, or up to the end of the input; "" if it was too
// long.
std::string StdioFront::takeLine(size_t end) {
  std::string line = tooLong_ ? std::string() : rest_.substr(0, end);
  rest_.erase(0, end == std::string::npos ? end : end + 1);
  searched_ = 0;
  tooLong_ = false;
  return line;
}

// Refuses a line once and skips the rest of it. Later lines are still answered.
void StdioFront::boundLine() {
  // A place of the largest size takes a third more in base64.
  if (!tooLong_ && rest_.size() > 2 * service_.limits().bodyBytes) {
    write(stdioReply("null", refuse(413, "the line is too long", "send a smaller place")));
    tooLong_ = true;
  }
  if (!tooLong_) return;
  std::string().swap(rest_);
  searched_ = 0;
}

kj::Promise<void> StdioFront::requests() {
  const size_t end = rest_.find('\n', searched_);
  searched_ = rest_.size();
  if (end != std::string::npos || inputEnded_) {
    std::string line = takeLine(end);
    const bool last = inputEnded_ && rest_.empty();
    auto answered = line.empty() ? kj::Promise<void>(kj::READY_NOW) : answer(std::move(line));
    if (last) return answered;
    return answered.then([this] { return requests(); });
  }
  boundLine();
  return readSome().then([this](size_t n) {
    rest_.append(buffer_, n);
    inputEnded_ = n == 0;
    return requests();
  });
}

kj::Promise<void> StdioFront::answer(std::string line) {
  StdioRequest request = parseStdioRequest(line);
  if (const Reply* refusal = std::get_if<Reply>(&request.call)) {
    write(stdioReply(request.id, *refusal));
    return kj::READY_NOW;
  }
  const Call call = std::get<Call>(request.call);
  return service_.handle(call, std::move(request.body))
      .then([this, id = std::move(request.id)](Reply reply) { write(stdioReply(id, reply)); });
}

// Writes messages as they come. Ends only when the output fails.
kj::Promise<void> StdioFront::events() {
  writeEvents();
  if (!outputStatus_) return kj::READY_NOW;
  return client_->whenWoken().then([this] { return events(); });
}

void StdioFront::writeEvents() {
  while (const Message* message = client_->ring().after(cursor_)) {
    cursor_ = message->number;
    write(message->text);
  }
}

// A job may write nothing for a long time. This detects early that the reader has gone.
kj::Promise<void> StdioFront::readerGone() {
  if (reader_.get() == nullptr) return kj::NEVER_DONE;
  return reader_->whenWriteDisconnected();
}

void StdioFront::write(std::string line) {
  line += '\n';
  if (outputStatus_) outputStatus_ = output_.write(line);
}

Status StdioFront::finish() {
  writeEvents();
  if (outputStatus_) outputStatus_ = output_.close();
  return outputStatus_;
}

}  // namespace obby::bridge
