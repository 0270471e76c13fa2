// Base64 with padding, the text that holds bytes in XML and JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace obby::io {

std::string encodeBase64(std::string_view bytes);

// Returns nullopt if the text is not base64. White space may stand anywhere, and the padding may be
// missing.
std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace obby::io
