#include "engine/child.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>

namespace obby::engine {
namespace {

bool sendAll(int pipe, const std::string& bytes) {
  size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t n = write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    sent += size_t(n);
  }
  return true;
}

// Runs the body in the child and ends the process.
void live(int pipe, const Children::Body& body) {
  const std::string bytes = body();
  const uint64_t size = bytes.size();  // first, so that the parent notices a child that dies midway
  const bool sent = sendAll(pipe, std::string(reinterpret_cast<const char*>(&size), sizeof size)) &&
                    sendAll(pipe, bytes);
  _exit(sent ? 0 : 1);
}

// Returns the bytes after the leading size, or nothing if some are missing.
std::string contents(const std::string& bytes) {
  uint64_t size = 0;
  if (bytes.size() < sizeof size) return {};
  std::copy_n(bytes.data(), sizeof size, reinterpret_cast<char*>(&size));
  return bytes.size() - sizeof size == size ? bytes.substr(sizeof size) : std::string{};
}

}  // namespace

Children::~Children() {
  while (!running_.empty()) end(0, true);
}

void Children::start(double seconds, const Body& body, Done done) {
  while (running_.size() >= max_) wait();
  int ends[2];
  if (pipe(ends) != 0) return done({});
  const int pid = fork();
  if (pid == 0) {
    close(ends[0]);
    for (const Running& other : running_) close(other.pipe);
    live(ends[1], body);
  }
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    return done({});
  }
  const auto limit =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  running_.push_back({pid, ends[0], Clock::now() + limit, {}, std::move(done)});
}

void Children::finish() {
  while (!running_.empty()) wait();
}

void Children::end(size_t index, bool killed) {
  Running ended = std::move(running_[index]);
  running_.erase(running_.begin() + std::ptrdiff_t(index));
  if (killed) ::kill(ended.pid, SIGKILL);
  close(ended.pipe);
  int status = 0;
  while (waitpid(ended.pid, &status, 0) < 0 && errno == EINTR) {
  }
  ended.done(killed ? std::string{} : contents(ended.bytes));
}

void Children::wait() {
  std::vector<pollfd> all;
  Clock::time_point first = Clock::time_point::max();
  for (const Running& one : running_) {
    all.push_back({one.pipe, POLLIN, 0});
    first = std::min(first, one.deadline);
  }
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count();
  const int ready = poll(all.data(), all.size(), int(std::clamp<long>(left + 1, 0, 60'000)));
  if (ready < 0 && errno != EINTR) return end(0, true);
  for (size_t i = running_.size(); i-- > 0;) {
    if (ready > 0 && all[i].revents != 0) {
      char buffer[1 << 16];
      const ssize_t n = read(all[i].fd, buffer, sizeof buffer);
      if (n > 0)
        running_[i].bytes.append(buffer, size_t(n));
      else if (n == 0 || errno != EINTR)
        end(i, false);
    } else if (Clock::now() >= running_[i].deadline) {
      end(i, true);
    }
  }
}

}  // namespace obby::engine
