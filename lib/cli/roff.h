// Formats text for roff.
#pragma once

#include <string>
#include <string_view>

namespace obby::cli::roff {

// Escapes `text` so that nothing in it is a request, an escape or a quote that changes its shape.
std::string escaped(std::string_view text);

// Formats an argument of a request, in quotes.
std::string argument(std::string_view text);

std::string bold(std::string_view text);
std::string italic(std::string_view text);

}  // namespace obby::cli::roff
