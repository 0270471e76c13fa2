// Parses with std::from_chars, and handles the spellings that it rejects.
#include "import/format/xml_numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "io/text.h"

namespace obby::importer {
namespace {

template <class Number>
std::optional<Number> whole(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template <class Real>
std::optional<Real> oldSpelling(std::string_view text) {
  const bool negative = text.substr(0, 1) == "-";
  const Real sign = negative ? Real(-1) : Real(1);
  if (negative) text.remove_prefix(1);
  if (text.substr(0, 3) != "1.#") return std::nullopt;
  if (text.substr(3, 3) == "INF") return sign * std::numeric_limits<Real>::infinity();
  const std::string_view what = text.substr(3, 4);
  if (what.substr(0, 3) == "IND" || what == "QNAN" || what == "SNAN") {
    return std::numeric_limits<Real>::quiet_NaN();
  }
  return std::nullopt;
}

template <class Real>
std::optional<Real> real(std::string_view text) {
  text = io::trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Real value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return oldSpelling<Real>(text);
  if (error == std::errc()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  const size_t exponent = text.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos ? text.substr(exponent + 1, 1) == "-"
                                                       : text.find('.') != std::string_view::npos;
  const Real sign = text[0] == '-' ? Real(-1) : Real(1);
  return sign * (tiny ? Real(0) : std::numeric_limits<Real>::infinity());
}

bool equalsIgnoringCase(std::string_view text, std::string_view lower) {
  if (text.size() != lower.size()) return false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c) != lower[i]) return false;
  }
  return true;
}

}  // namespace

std::optional<float> parseFloat(std::string_view text) { return real<float>(text); }
std::optional<double> parseDouble(std::string_view text) { return real<double>(text); }

std::optional<int64_t> parseInt(std::string_view text) {
  text = io::trimmed(text);
  if (const auto value = whole<int64_t>(text)) return value;
  if (const auto value = whole<uint64_t>(text)) return static_cast<int64_t>(*value);
  const auto value = real<double>(text);
  if (value && std::abs(*value) < 9.0e15 && std::floor(*value) == *value) {
    return static_cast<int64_t>(*value);
  }
  return std::nullopt;
}

std::optional<bool> parseBool(std::string_view text) {
  text = io::trimmed(text);
  if (text == "1" || equalsIgnoringCase(text, "true")) return true;
  if (text == "0" || equalsIgnoringCase(text, "false")) return false;
  return std::nullopt;
}

}  // namespace obby::importer
