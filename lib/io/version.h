// Versions that streams and tools state.
#pragma once

#include <cstdint>

namespace obby::io {

inline constexpr uint32_t kSchemaMajor = 2;  // raised when old readers would misread a stream
inline constexpr uint32_t kSchemaMinor = 0;  // raised when fields are added
// JSON records name their fields and omit defaults, so older versions can be read.
inline constexpr uint32_t kOldestJsonMajor = 1;
inline constexpr const char* kFloatPolicy = "ieee754-nofma";

// Returns the program's version, "0.1.0".
const char* toolVersion();

}  // namespace obby::io
