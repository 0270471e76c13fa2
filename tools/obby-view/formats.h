// The output formats of obby-view, one row each.
#pragma once

#include <span>
#include <string>

#include "cli/context.h"
#include "view/report.h"

namespace obby {

struct ViewFormat {
  const char* name;  // value of --format
  // File name endings that select the format, each with a leading dot and a trailing space.
  const char* endings;
  bool binary;  // not for terminals
  bool page;    // needs the page's bundle
  Result<std::string> (*render)(const view::Report& report, const cli::Context& context);
};

std::span<const ViewFormat> viewFormats();

// Returns the format of --format, else that of the output's name, else text.
const ViewFormat& wantedFormat(const cli::Arguments& arguments);

// Error: no format has the ending of the output's name, and --format is missing.
Status checkEnding(const cli::Arguments& arguments);

}  // namespace obby
