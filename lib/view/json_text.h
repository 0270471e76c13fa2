// Writes the page's data as JSON that is safe inside an HTML script element. Numeric arrays are
// base64 of their little-endian bytes.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace obby::view {

// Appends to one string. The writer sets commas; the caller pairs open() and close().
class JsonText {
 public:
  JsonText& open(char bracket);  // '{' or '['
  JsonText& close();
  JsonText& key(std::string_view name);

  // Writes `<` as \u003c, so that no text can end the script element. Invalid UTF-8 becomes U+FFFD.
  JsonText& value(std::string_view text);
  JsonText& value(const char* text) { return value(std::string_view(text)); }
  JsonText& value(bool flag);
  JsonText& value(double number);  // null if not finite
  JsonText& value(float number);   // shortest text that parses to the same float
  template <std::integral T>
  requires(!std::same_as<T, bool>) JsonText& value(T number) { return raw(std::to_string(number)); }
  JsonText& null() { return raw("null"); }
  template <class T>
  JsonText& array(std::span<const T> values) {
    return base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  template <class T>
  JsonText& array(const std::vector<T>& values) {
    return array(std::span<const T>(values));
  }
  template <class T>
  JsonText& field(std::string_view name, const T& v) {
    return key(name).value(v);
  }

  // Appends text that is JSON already.
  JsonText& raw(std::string_view text);

  const std::string& text() const { return text_; }

 private:
  JsonText& base64(std::string_view bytes);
  void separate();

  std::string text_;
  std::vector<char> closers_;
  bool comma_ = false;
};

}  // namespace obby::view
