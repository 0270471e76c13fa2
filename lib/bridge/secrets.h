// Pairing codes and tokens, which authorize clients. Codes allow few tries.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace obby::bridge {

inline constexpr size_t kCodeLetters = 8;

// The code that a user copies from the terminal to the plugin. Each code is good for one token.
class Pairing {
 public:
  static constexpr double kSeconds = 300;
  static constexpr int kTries = 5;

  // Makes a code that is valid from `now` on, in seconds of any steady clock. Its letters exclude
  // 0, O, 1 and I.
  explicit Pairing(double now);
  // Returns "ABCD-EFGH".
  std::string shown() const;
  // Returns why the code can no longer be used, or "" if it can.
  const char* closed(double now) const;
  // Checks a code; case and dashes do not matter. A right answer, or the last try, closes the
  // pairing.
  bool answer(std::string_view code, double now);
  int triesLeft() const { return tries_; }

 private:
  std::string code_;
  double until_;
  int tries_ = kTries;
  bool used_ = false;
};

// The tokens of the paired clients, in a file that only this user may read.
class Tokens {
 public:
  // Reads the tokens in `path`. A missing file means no tokens. Errors: others may read the file,
  // or it holds anything but tokens.
  static Result<Tokens> open(std::string path, size_t max);
  // Makes an empty set that is kept in memory only, for tests and for a bridge without a file.
  Tokens() = default;

  // Makes a token and writes it to the file. The oldest is dropped if there are too many.
  Result<std::string> add();
  // Returns the token's client, a number that is stable while this object lives, or -1 for none.
  int clientOf(std::string_view token) const;
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    std::string token;
    int client = 0;
  };
  Status write(const std::vector<Entry>& entries) const;

  std::string path_;
  size_t max_ = 16;
  std::vector<Entry> entries_;
  int next_ = 0;
};

}  // namespace obby::bridge
