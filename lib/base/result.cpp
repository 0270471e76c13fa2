#include "base/result.h"

namespace obby {

std::string Error::text() const {
  std::string out = input;
  if (!place.empty()) out += (out.empty() ? "" : ":") + place;
  if (!path.empty()) out += (out.empty() ? "" : ": ") + path;
  if (!message.empty()) out += (out.empty() ? "" : ": ") + message;
  if (!hint.empty()) out += " (" + hint + ")";
  return out;
}

}  // namespace obby
