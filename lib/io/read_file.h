// A whole file in memory, for inputs that are no streams of records.
#pragma once

#include <atomic>
#include <string>

#include "base/result.h"

namespace obby::io {

class ByteSource;

// `path` "-" is standard input. Errors name the file and the reason. Once `stop` is set a call that
// waits ends with an error of isInterrupted(); without `stop` a signal does that to it.
Result<std::string> readFile(const std::string& path, const std::atomic<bool>* stop = nullptr);

// The same of what is not yet consumed of an input that is open.
Result<std::string> readRest(ByteSource& source);

// True for the error of a read, or of an output, that was told to stop: end as the signal says.
bool isInterrupted(const Error& error);

}  // namespace obby::io
