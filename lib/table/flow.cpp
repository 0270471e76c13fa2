#include "table/flow.h"

#include <algorithm>
#include <utility>

#include "table/columns.h"

namespace obby::table {

Flow::Flow(size_t width, size_t gap, std::string indent)
    : width_(width - std::min(width, columnCount(indent))),
      gap_(gap),
      indent_(std::move(indent)),
      out_(indent_) {}

void Flow::add(std::string_view piece, size_t columns) {
  const bool fits = begun_ && used_ + gap_ + columns <= width_;
  if (begun_) out_ += fits ? std::string(gap_, ' ') : "\n" + indent_;
  out_ += piece;
  used_ = fits ? used_ + gap_ + columns : columns;
  begun_ = true;
}

}  // namespace obby::table
