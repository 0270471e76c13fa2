// The one form in which a record has one sequence of words: fields that say nothing (values.h) are
// null, structs have their full size, everything lies in one segment in the order of the schema.
// Copying into it checks every value, so that nobody who reads the copy meets a broken pointer, a
// NaN or bad text. Private to lib/io.
#pragma once

#include <kj/exception.h>

#include <memory>
#include <string>

#include "base/result.h"
#include "io/checks.h"
#include "io/path.h"
#include "io/record.h"

namespace obby::io {

// The copy, in one segment if `in` was written by this version and has `words` words, or fewer. The
// kind must be known. Errors name the path. May throw kj::Exception where `in` is an unsound
// message.
Result<RecordBuilder> normalForm(schema::Record::Reader in, uint64_t words);

// What Cap'n Proto found wrong with a message, in its words without its source code.
Error unsoundMessage(const kj::Exception& exception);

}  // namespace obby::io
