// Texts as roff takes them.
#pragma once

#include <string>
#include <string_view>

namespace obby::cli::roff {

// `text` as it is to be read: nothing in it is a request, an escape or a quote that is turned.
std::string escaped(std::string_view text);

// As an argument of a request: in quotes.
std::string argument(std::string_view text);

std::string bold(std::string_view text);
std::string italic(std::string_view text);

}  // namespace obby::cli::roff
