// A whole file in memory, for inputs that are no streams of records.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "base/result.h"

namespace obby::io {

class ByteSource;

// Bytes of a file that is read whole, at most: ten times the largest place that Roblox takes. An
// input without end, as a device or a stream that was not meant, would take all memory.
inline constexpr uint64_t kMostFileBytes = uint64_t(1) << 30;

// `path` "-" is standard input. Errors name the file and the reason; one is that it has more than
// `most` bytes. Once `stop` is set a call that waits ends with an error of isInterrupted(); without
// `stop` a signal does that to it.
Result<std::string> readFile(const std::string& path, const std::atomic<bool>* stop = nullptr,
                             uint64_t most = kMostFileBytes);

// The same of what is not yet consumed of an input that is open.
Result<std::string> readRest(ByteSource& source, uint64_t most = kMostFileBytes);

// True for the error of a read, or of an output, that was told to stop: end as the signal says.
bool isInterrupted(const Error& error);

}  // namespace obby::io
