// What obby-view can write: a row a format.
#pragma once

#include <span>
#include <string>

#include "cli/context.h"
#include "view/report.h"

namespace obby {

struct ViewFormat {
  const char* name;     // of --format
  const char* endings;  // of file names that choose it, each with a dot before and a space behind
  bool binary;          // not for a terminal
  bool page;            // needs the page's bundle
  Result<std::string> (*render)(const view::Report& report, const cli::Context& context);
};

std::span<const ViewFormat> viewFormats();

// By --format, else by the output's name, else text.
const ViewFormat& wantedFormat(const cli::Arguments& arguments);

// Error: no format has the ending of the output's name, and there is no --format.
Status checkEnding(const cli::Arguments& arguments);

}  // namespace obby
