// Secrets by which a server knows who may ask: random, compared in constant time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::loopback {

// Of a token: as many bits as nobody can guess.
inline constexpr size_t kTokenBytes = 32;

// So many bytes of the system's randomness. Throws where the system has none.
std::string randomBytes(size_t bytes);
// Likewise as twice as many hexadecimal digits.
std::string randomHex(size_t bytes);

// Takes as long whatever the difference is. The lengths are no secret.
bool equalInConstantTime(std::string_view a, std::string_view b);

}  // namespace obby::loopback
