#include "io/base64.h"

#include <kj/encoding.h>

namespace obby::io {

std::string encodeBase64(std::string_view bytes) {
  const kj::ArrayPtr<const char> from(bytes.data(), bytes.size());
  const kj::String text = kj::encodeBase64(from.asBytes());
  return {text.cStr(), text.size()};
}

std::optional<std::string> decodeBase64(std::string_view text) {
  const auto bytes = kj::decodeBase64(kj::ArrayPtr<const char>(text.data(), text.size()));
  if (bytes.hadErrors) return std::nullopt;
  return std::string(bytes.asChars().begin(), bytes.size());
}

}  // namespace obby::io
