// Pieces of text side by side, in as many lines as a width takes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::table {

class Flow {
 public:
  // Lines of `width` columns, the `indent` before each included; pieces are `gap` columns apart.
  Flow(size_t width, size_t gap, std::string indent = {});

  // `columns`: that it takes on a terminal, which colour sequences do not. One that is wider than a
  // line has one of its own, and is not cut.
  void add(std::string_view piece, size_t columns);

  // Lines end in newlines.
  std::string text() const { return out_ + "\n"; }

 private:
  size_t width_, gap_;
  std::string indent_, out_;
  size_t used_ = 0;  // columns of the last line
  bool begun_ = false;
};

}  // namespace obby::table
