// The memory of a record that is being built. If none is left it throws std::bad_alloc, as other
// code does, instead of an exception of Cap'n Proto that names its source code.
#pragma once

#include <capnp/message.h>

namespace obby::io {

class RecordMemory final : public capnp::MallocMessageBuilder {
 public:
  using MallocMessageBuilder::MallocMessageBuilder;
  kj::ArrayPtr<capnp::word> allocateSegment(unsigned int minimumWords) override;
};

}  // namespace obby::io
