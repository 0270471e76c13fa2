// SIGINT and SIGTERM: the first asks the tool to finish what is done, a SIGINT some time after it
// ends it. One that comes at once is the same signal, sent twice.
#pragma once

#include <atomic>

namespace obby::cli {

// The exit code of a process that a signal ended is this plus the signal's number.
inline constexpr int kSignalExit = 128;

// Set by the handler. Lives as long as the process.
const std::atomic<bool>& stopFlag();
// The signal that set it; 0: none.
int stopSignal();
// A signal that the parent had ignored stays ignored.
void installStopHandlers();

}  // namespace obby::cli
