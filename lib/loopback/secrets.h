// Secrets that authorize requests to a server: random, and compared in constant time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::loopback {

// Length of a token, long enough that it cannot be guessed.
inline constexpr size_t kTokenBytes = 32;

// Returns that many random bytes from the system. Throws if the system has none.
std::string randomBytes(size_t bytes);
// Returns `bytes` random bytes as hexadecimal digits, two for each byte.
std::string randomHex(size_t bytes);

// Compares texts in a time that does not depend on where they differ. The lengths are not secret.
bool equalInConstantTime(std::string_view a, std::string_view b);

}  // namespace obby::loopback
