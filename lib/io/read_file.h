// Reads a whole file into memory, for inputs that are not streams of records.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "base/result.h"

namespace obby::io {

class ByteSource;

// Max bytes of a file that is read whole: ten times the largest place that Roblox accepts. Without
// a limit, an endless input such as a device would take all memory.
inline constexpr uint64_t kMaxFileBytes = uint64_t(1) << 30;

// `path` "-" is standard input. Errors name the file and the reason; more than `max` bytes are an
// error. Once `stop` is set, a waiting call ends with an error of isInterrupted(). Without `stop`,
// a signal does the same.
Result<std::string> readFile(const std::string& path, const std::atomic<bool>* stop = nullptr,
                             uint64_t max = kMaxFileBytes);

// Reads the rest of an open input. Errors are those of readFile().
Result<std::string> readRest(ByteSource& source, uint64_t max = kMaxFileBytes);

// Returns true for the error of a read, or of an output, that was asked to stop. The tool should
// then end as the signal asks.
bool isInterrupted(const Error& error);

}  // namespace obby::io
