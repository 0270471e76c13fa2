// The option table of obby-view, and what it comes to.
#pragma once

#include "cli/context.h"
#include "cli/tool.h"
#include "view/text_report.h"

namespace obby {

cli::ToolSpec viewSpec();

// True if the user asked for the page, by --format or by the output's name.
bool wantsPage(const cli::Arguments& arguments);
view::TextOptions textOptions(const cli::Context& context);

}  // namespace obby
