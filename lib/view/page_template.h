// The viewer page that the build bundled: text with two markers that page.cpp fills in.
#pragma once

#include <span>
#include <string_view>

namespace obby::view {

inline constexpr std::string_view kTitleMarker = "@@OBBY_TITLE@@";
inline constexpr std::string_view kDataMarker = "@@OBBY_DATA@@";
// The content security policy begins so.
inline constexpr std::string_view kPolicyStart = "default-src 'none'";

// The page in pieces, to be put together; empty in a build without the page bundle. Each of
// these occurs exactly once in the whole.
std::span<const std::string_view> pageTemplate();

}  // namespace obby::view
