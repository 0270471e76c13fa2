// Decodes Base64 as XML files use it: white space anywhere, padding optional.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace obby::importer {

// Returns nullopt if a character is neither base64 nor white space, or follows the padding.
std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace obby::importer
