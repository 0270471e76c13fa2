#include "loopback/sender.h"

#include <fmt/format.h>

#include <string>

#include "base/spelling.h"

namespace obby::loopback {

bool hostAllowed(std::string_view host, uint16_t port) {
  const std::string found = lower(host);
  for (const char* name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (found == fmt::format("{}:{}", name, port)) return true;
    if (port == 80 && found == name) return true;
  }
  return false;
}

bool originIsOwn(std::string_view origin, uint16_t port) {
  constexpr std::string_view kScheme = "http://";
  return lower(origin.substr(0, kScheme.size())) == kScheme &&
         hostAllowed(origin.substr(kScheme.size()), port);
}

}  // namespace obby::loopback
