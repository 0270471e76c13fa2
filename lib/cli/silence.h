// Discards a standard stream for a while.
#pragma once

namespace obby::cli {

class Silence {
 public:
  // Output to the descriptor is discarded while this object lives.
  explicit Silence(int descriptor);
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int descriptor_, kept_;
};

}  // namespace obby::cli
