// Results of functions that read input: a value, or an error that names the place and the remedy.
// Broken invariants are caught by OBBY_CHECK (check.h). Overflows inside a batch set flag bits of
// the world. The library never prints or exits.
//
//   Result<Level> load(const std::string& path) {
//     OBBY_ASSIGN(const std::string text, readFile(path));  // an error of readFile is returned
//     if (text.empty()) return makeError("expected a level, found an empty file");
//     return parsed(text);
//   }
//   if (const auto level = load("a.jsonl"); !level) show(level.error().text());
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace obby {

// An error in an input, from the outermost place to the innermost. Any field may be empty.
struct Error {
  std::string input;    // file name, "stdin", or ""
  std::string place;    // "12" (line) or "byte 4711"
  std::string path;     // place inside the record: "parts[88].size"
  std::string message;  // expected and found value; one line, no full stop
  std::string hint;     // a way to fix the input; may be empty

  // Returns one line: "level.jsonl:12: parts[88].size: expected 3 numbers (hint)".
  std::string text() const;
};

// Returns an error without a place. Callers that know the input and the place add them.
inline Error makeError(std::string message, std::string hint = {}) {
  return Error{{}, {}, {}, std::move(message), std::move(hint)};
}

// A value or an Error. Test with `if (!r)`, then use r.error() or *r. `*r` of an error throws
// std::bad_variant_access, as does error() of a value.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Result(Error error)
      : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() & { return std::get<0>(state_); }
  const T& operator*() const& { return std::get<0>(state_); }
  T&& operator*() && { return std::get<0>(std::move(state_)); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }
  Error& error() & { return std::get<1>(state_); }
  const Error& error() const& { return std::get<1>(state_); }
  Error&& error() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Error> state_;
};

// Success or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return !error_.has_value(); }
  Error& error() & { return *error_; }
  const Error& error() const& { return *error_; }
  Error&& error() && { return std::move(*error_); }

 private:
  std::optional<Error> error_;
};

using Status = Result<void>;

// Standard C++ has no expression that returns early, so these two macros are statements.
// OBBY_RETURN_IF_ERROR(f()) returns the error of a Result, if it has one.
#define OBBY_RETURN_IF_ERROR(expr)                                                   \
  do {                                                                               \
    if (auto obbyStatus = (expr); !obbyStatus) return std::move(obbyStatus).error(); \
  } while (false)

#define OBBY_CONCAT_INNER(a, b) a##b
#define OBBY_CONCAT(a, b) OBBY_CONCAT_INNER(a, b)
// OBBY_ASSIGN(auto x, f()) sets x to the value, or returns the error from the enclosing function.
#define OBBY_ASSIGN(declaration, expr)                           \
  auto OBBY_CONCAT(obbyResult, __LINE__) = (expr);               \
  if (!OBBY_CONCAT(obbyResult, __LINE__))                        \
    return std::move(OBBY_CONCAT(obbyResult, __LINE__)).error(); \
  declaration = *std::move(OBBY_CONCAT(obbyResult, __LINE__))

}  // namespace obby
