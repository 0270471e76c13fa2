#include "io/record_memory.h"

#include <kj/exception.h>

#include <new>

namespace obby::io {

kj::ArrayPtr<capnp::word> RecordMemory::allocateSegment(unsigned int minimumWords) {
  try {
    return MallocMessageBuilder::allocateSegment(minimumWords);
  } catch (const kj::Exception& e) {
    if (e.getType() == kj::Exception::Type::OVERLOADED) throw std::bad_alloc();  // ENOMEM
    throw;
  }
}

}  // namespace obby::io
