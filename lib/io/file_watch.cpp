#include "io/file_watch.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

namespace obby::io {

namespace {

constexpr std::chrono::milliseconds kQuiet{60};  // enough for an editor that saves in pieces

}  // namespace

FileWatch::State FileWatch::stateOf(const std::string& path) {
  std::error_code none;
  const auto written = std::filesystem::last_write_time(path, none);
  if (none) return {0, 0};
  const uint64_t bytes = std::filesystem::file_size(path, none);
  return {none ? 0 : bytes, int64_t(written.time_since_epoch().count())};
}

FileWatch::FileWatch(std::vector<std::string> paths) : paths_(std::move(paths)) {
  for (const std::string& path : paths_) states_.push_back(stateOf(path));
}

bool FileWatch::changed() const {
  for (size_t i = 0; i < paths_.size(); ++i) {
    if (!(stateOf(paths_[i]) == states_[i])) return true;
  }
  return false;
}

void FileWatch::settle(const std::atomic<bool>& stop) {
  do {
    for (size_t i = 0; i < paths_.size(); ++i) states_[i] = stateOf(paths_[i]);
    std::this_thread::sleep_for(kQuiet);
  } while (changed() && !stop);
}

}  // namespace obby::io
