// Serialises plain structs between a process and the child that it has forked: same program, same
// machine. A struct lists its fields once: fields(archive, value) calls archive(field) for each.
// Private to lib/engine.
#pragma once

#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace obby::engine {

template <class T>
concept PlainBytes = std::is_trivially_copyable_v<T>;

class BytesOut {
 public:
  template <PlainBytes T>
  void operator()(T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(std::string& value) {
    size_t size = value.size();
    (*this)(size);
    bytes += value;
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    size_t size = list.size();
    (*this)(size);
    for (T& one : list) (*this)(one);
  }
  template <class K, class V>
  void operator()(std::map<K, V>& map) {
    size_t size = map.size();
    (*this)(size);
    for (auto& [key, value] : map) {
      K copy = key;
      (*this)(copy);
      (*this)(value);
    }
  }
  template <class... T>
  void operator()(std::variant<T...>& value) {
    size_t index = value.index();
    (*this)(index);
    std::visit([this](auto& held) { (*this)(held); }, value);
  }
  template <class T>
  requires(!PlainBytes<T>) void operator()(T& value) { fields(*this, value); }

  std::string bytes;
};

// Reads the output of BytesOut. `good` turns false if bytes are missing.
class BytesIn {
 public:
  explicit BytesIn(std::string_view bytes) : left_(bytes) {}

  template <PlainBytes T>
  void operator()(T& value) {
    const std::string_view from = take(sizeof value);
    if (good) std::memcpy(&value, from.data(), sizeof value);
  }
  void operator()(std::string& value) { value = take(size()); }
  template <class T>
  void operator()(std::vector<T>& list) {
    const size_t count = size();
    for (size_t i = 0; i < count && good; ++i) (*this)(list.emplace_back());
  }
  template <class K, class V>
  void operator()(std::map<K, V>& map) {
    const size_t count = size();
    for (size_t i = 0; i < count && good; ++i) {
      K key{};
      (*this)(key);
      (*this)(map[key]);
    }
  }
  template <class... T>
  void operator()(std::variant<T...>& value) {
    hold<0, T...>(value, size());
  }
  template <class T>
  requires(!PlainBytes<T>) void operator()(T& value) { fields(*this, value); }

  bool good = true;

 private:
  size_t size() {
    size_t value = 0;
    (*this)(value);
    return good ? value : 0;
  }
  std::string_view take(size_t count) {
    good = good && count <= left_.size();
    const std::string_view taken = left_.substr(0, good ? count : 0);
    if (good) left_.remove_prefix(count);
    return taken;
  }
  template <size_t kIndex, class... T>
  void hold(std::variant<T...>& value, size_t index) {
    if constexpr (kIndex < sizeof...(T)) {
      if (index != kIndex) return hold<kIndex + 1>(value, index);
      (*this)(value.template emplace<kIndex>());
    } else {
      good = false;
    }
  }

  std::string_view left_;
};

}  // namespace obby::engine
