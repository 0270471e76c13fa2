// Discards a standard stream for a while.
#pragma once

namespace obby::cli {

class Silence {
 public:
  // What is written to the descriptor is discarded while this lives.
  explicit Silence(int descriptor);
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int descriptor_, kept_;
};

}  // namespace obby::cli
