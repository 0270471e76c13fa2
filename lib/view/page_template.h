// The bundled viewer page: text with two markers for page.cpp to replace.
#pragma once

#include <span>
#include <string_view>

namespace obby::view {

inline constexpr std::string_view kTitleMarker = "@@OBBY_TITLE@@";
inline constexpr std::string_view kDataMarker = "@@OBBY_DATA@@";
// Start of the content security policy.
inline constexpr std::string_view kPolicyStart = "default-src 'none'";

// Returns the page in pieces to concatenate, or none in a build without the page bundle. Each of
// the texts above occurs exactly once in the whole.
std::span<const std::string_view> pageTemplate();

}  // namespace obby::view
