// Versions that streams and tools name.
#pragma once

#include <cstdint>

namespace obby::io {

inline constexpr uint32_t kSchemaMajor = 1;  // raised when old readers would misread a stream
inline constexpr uint32_t kSchemaMinor = 4;  // raised when fields are added
inline constexpr const char* kFloatPolicy = "ieee754-nofma";

// The program's version, "0.1.0".
const char* toolVersion();

}  // namespace obby::io
