#include "loopback/secrets.h"

#include <errno.h>
#include <fmt/format.h>
#include <sys/random.h>

#include <stdexcept>

namespace obby::loopback {

std::string randomBytes(size_t bytes) {
  std::string out(bytes, '\0');
  size_t done = 0;
  while (done < bytes) {
    const ssize_t n = getrandom(out.data() + done, bytes - done, 0);
    if (n > 0) done += size_t(n);
    // Without randomness there is no secret, so the server must not continue.
    if (n < 0 && errno != EINTR) throw std::runtime_error("the system provides no random numbers");
  }
  return out;
}

std::string randomHex(size_t bytes) {
  std::string out;
  for (const char c : randomBytes(bytes)) out += fmt::format("{:02x}", uint8_t(c));
  return out;
}

bool equalInConstantTime(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  volatile uint8_t differences = 0;  // volatile keeps the compiler from returning early
  for (size_t i = 0; i < a.size(); i++) differences = differences | uint8_t(a[i] ^ b[i]);
  return differences == 0;
}

}  // namespace obby::loopback
