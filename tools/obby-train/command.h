// Options as a shell reads them.
#pragma once

#include <string>

#include "cli/arguments.h"

namespace obby::tools {

// As a shell reads it back: in quotes where it has to be.
std::string wordOf(const std::string& text);

// "--seed 3", "--style gaps --style 'a b'", "--resume=auto". Empty: a flag that is off, or an
// option that has neither a value nor a default.
std::string asTyped(const std::string& name, const cli::Arguments::Value& value);

// What was asked for, as a command that asks for it again; without --resume.
std::string commandOf(const cli::Arguments& arguments);

}  // namespace obby::tools
