// Pairing codes and tokens: who may ask the bridge, after few tries.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace obby::bridge {

inline constexpr size_t kCodeLetters = 8;

// The code that a person carries from the terminal to the plugin. One token for one code.
class Pairing {
 public:
  static constexpr double kSeconds = 300;
  static constexpr int kTries = 5;

  // A new code from `now` on, in seconds of any steady clock. The letters are without 0, O, 1 and
  // I.
  explicit Pairing(double now);
  // "ABCD-EFGH"
  std::string shown() const;
  // Why the code can no longer be used; empty: it can.
  const char* closed(double now) const;
  // Case and dashes do not matter. A right answer, or the last try, closes it.
  bool answer(std::string_view code, double now);
  int triesLeft() const { return tries_; }

 private:
  std::string code_;
  double until_;
  int tries_ = kTries;
  bool used_ = false;
};

// The tokens of the paired clients, in a file that only this user may read. Position is the client.
class Tokens {
 public:
  // Reads `path`; no file means no tokens. Error: others may read it, or it holds anything else.
  static Result<Tokens> open(std::string path, size_t most);
  // Those of no file, for tests and where none are needed.
  Tokens() = default;

  // A new token, written to the file; the oldest one goes when there are too many.
  Result<std::string> add();
  // The token's client: a number that stays the client's while this object lives; -1: nobody.
  int clientOf(std::string_view token) const;
  bool empty() const { return entries_.empty(); }

 private:
  struct Entry {
    std::string token;
    int client = 0;
  };
  Status write(const std::vector<Entry>& entries) const;

  std::string path_;
  size_t most_ = 16;
  std::vector<Entry> entries_;
  int next_ = 0;
};

}  // namespace obby::bridge
