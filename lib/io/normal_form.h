// The normal form of a record, in which equal records have equal words. Fields that are not set
// (checks.h) are null, structs have their full size, and everything is in one segment in the order
// of the schema. Copying checks every value, so that readers of the copy never meet a broken
// pointer, a NaN or bad text. Private to lib/io.
#pragma once

#include <kj/exception.h>

#include <memory>
#include <string>

#include "base/result.h"
#include "io/checks.h"
#include "io/path.h"
#include "io/record.h"

namespace obby::io {

// Returns the normal form of `in`, in one segment if this version wrote `in` and `in` has at most
// `words` words. The kind must be known. Errors name the path. May throw kj::Exception if `in` is
// an unsound message.
Result<RecordBuilder> normalForm(schema::Record::Reader in, uint64_t words);

// Returns Cap'n Proto's reason why a message is unsound, without the place in its source code.
Error unsoundMessage(const kj::Exception& exception);

}  // namespace obby::io
