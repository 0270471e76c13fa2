// Arranges pieces of text next to each other, in as many lines as they need.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::table {

class Flow {
 public:
  // Makes lines of at most `width` columns, including the `indent` of each. Pieces in a line are
  // `gap` columns apart.
  Flow(size_t width, size_t gap, std::string indent = {});

  // Adds a piece that takes `columns` on a terminal, where colour sequences take none. A piece that
  // is wider than a line gets its own line and is not cut.
  void add(std::string_view piece, size_t columns);

  // Returns the lines, each with a newline at its end.
  std::string text() const { return out_ + "\n"; }

 private:
  size_t width_, gap_;
  std::string indent_, out_;
  size_t used_ = 0;  // columns of the last line that are used
  bool begun_ = false;
};

}  // namespace obby::table
