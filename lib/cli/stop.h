// SIGINT and SIGTERM: the first asks the tool to complete its results, and a later SIGINT ends it.
// A signal that follows immediately counts as the first one, sent twice.
#pragma once

#include <atomic>

namespace obby::cli {

// The exit code of a process that a signal ended is this plus the signal's number.
inline constexpr int kSignalExit = 128;

// Returns the flag that the handler sets. It lives as long as the process.
const std::atomic<bool>& stopFlag();
// Returns the signal that set the flag, or 0 if none did.
int stopSignal();
// Installs the handlers. A signal that the parent has ignored stays ignored.
void installStopHandlers();

}  // namespace obby::cli
