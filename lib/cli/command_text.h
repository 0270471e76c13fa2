// Writes options as text for a shell. Parsing the text yields the same options.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "cli/arguments.h"

namespace obby::cli {

// Returns the text as one word, in quotes if necessary.
std::string shellWord(const std::string& text);

// Returns "--seed 3", "--style gaps --style 'a b'" or "--resume=auto". Returns "" for a flag that
// is off, and for an option without a value.
std::string optionText(const std::string& name, const Arguments::Value& value);

// Returns a command line with the same arguments, except the options `without`.
std::string commandText(const std::string& tool, const Arguments& arguments,
                        std::initializer_list<const char*> without);

// Returns how the tool was started, to compare with another process. The list has "with --seed 3",
// "without --style" and so on for all options except `without`, then the inputs. Two lists of one
// tool have the same order.
std::vector<std::string> optionTexts(const Arguments& arguments,
                                     std::initializer_list<const char*> without);

}  // namespace obby::cli
