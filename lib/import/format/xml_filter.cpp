// Filters with one walk over the source, which the search for an offset shares.
#include "import/format/xml_filter.h"

#include <cstdint>

namespace obby::importer {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

// Returns the length of the reference at the start of `text` ("&#0;") if it must be replaced,
// otherwise 0.
size_t badReference(std::string_view text) {
  size_t i = 2;
  const bool hex = text.substr(i, 1) == "x";
  if (hex) ++i;
  uint32_t code = 0;
  const size_t firstDigit = i;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    uint32_t digit = 0;
    if (c >= '0' && c <= '9') {
      digit = static_cast<uint32_t>(c - '0');
    } else if (hex && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'))) {
      digit = static_cast<uint32_t>((c | 0x20) - 'a' + 10);
    } else {
      break;
    }
    if (code <= 0x10ffff) code = code * (hex ? 16 : 10) + digit;
  }
  if (i == firstDigit || i >= text.size() || text[i] != ';') return 0;
  const bool bad = code == 0 || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff);
  return bad ? i + 1 : 0;
}

// Returns the length of the comment or CDATA section at the start of `text`, or 0.
size_t opaqueLength(std::string_view text) {
  for (const auto& [begin, end] :
       {std::pair<std::string_view, std::string_view>{"<![CDATA[", "]]>"},
        std::pair<std::string_view, std::string_view>{"<!--", "-->"}}) {
    if (text.substr(0, begin.size()) != begin) continue;
    const size_t at = text.find(end, begin.size());
    return at == std::string_view::npos ? text.size() : at + end.size();
  }
  return 0;
}

// Calls keep(piece) and replace(length of the replaced piece), in order.
template <class Keep, class Replace>
void walk(std::string_view source, Keep keep, Replace replace) {
  size_t done = 0;
  for (size_t i = source.find_first_of("<&"); i != std::string_view::npos;
       i = source.find_first_of("<&", i)) {
    const std::string_view rest = source.substr(i);
    if (const size_t opaque = opaqueLength(rest); opaque > 0) {
      i += opaque;
      continue;
    }
    const size_t bad = rest.substr(0, 2) == "&#" ? badReference(rest) : 0;
    if (bad > 0) {
      keep(source.substr(done, i - done));
      replace(bad);
      done = i + bad;
    }
    i += bad > 0 ? bad : 1;
  }
  keep(source.substr(done));
}

}  // namespace

FilteredXml filterXml(std::string_view source) {
  FilteredXml out;
  out.text.reserve(source.size());
  walk(
      source, [&out](std::string_view piece) { out.text += piece; },
      [&out](size_t) {
        out.text += kReplacement;
        ++out.replaced;
      });
  return out;
}

size_t sourceOffset(std::string_view source, size_t offset) {
  size_t filtered = 0, skew = 0;  // skew: source length minus filtered length so far
  walk(
      source, [&](std::string_view piece) { filtered += piece.size(); },
      [&](size_t length) {
        if (filtered < offset) skew += length - kReplacement.size();
        filtered += kReplacement.size();
      });
  return offset + skew;
}

}  // namespace obby::importer
