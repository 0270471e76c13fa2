// Writes JSON text of any shape. All JSON of the project goes through here: records, the viewer's
// page, the bridge's replies, messages of the tools, lines of the benches.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace obby::io {

// Appends to one string and sets the commas:
//   JsonWriter().open('{').field("job", 7).key("names").open('[').value("a").finish()
// returns {"job":7,"names":["a"]}.
class JsonWriter {
 public:
  JsonWriter& open(char bracket);  // '{' or '['
  JsonWriter& close();             // closes the innermost bracket

  // Writes the name of an object's member. Its value follows.
  JsonWriter& key(std::string_view name);

  JsonWriter& value(std::string_view text);  // U+FFFD for a byte that is not UTF-8
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(bool flag) { return raw(flag ? "true" : "false"); }
  // The shortest text that parses to the same number; null if not finite.
  JsonWriter& value(double number);
  JsonWriter& value(float number);
  template <std::integral T>
  requires(!std::same_as<T, bool>) JsonWriter& value(T number) {
    const fmt::format_int digits(number);
    return raw({digits.data(), digits.size()});
  }
  JsonWriter& null() { return raw("null"); }
  // Appends text that is JSON already.
  JsonWriter& raw(std::string_view json);

  // Writes numbers as one string: base64 of their little-endian bytes.
  template <class T>
  JsonWriter& packed(const std::vector<T>& numbers) {
    return base64({reinterpret_cast<const uint8_t*>(numbers.data()), numbers.size() * sizeof(T)});
  }

  template <class T>
  JsonWriter& field(std::string_view name, const T& v) {
    return key(name).value(v);
  }
  // Writes an array of the values.
  template <class Range>
  JsonWriter& list(const Range& values) {
    open('[');
    for (const auto& each : values) value(each);
    return close();
  }

  const std::string& text() const { return text_; }
  // Closes all brackets and moves the text out.
  std::string finish();

 private:
  JsonWriter& base64(std::span<const uint8_t> bytes);
  void separate() {
    if (comma_) text_ += ',';
    comma_ = true;
  }

  std::string text_;
  std::string closers_;  // the closing brackets of all open brackets
  bool comma_ = false;
};

}  // namespace obby::io
