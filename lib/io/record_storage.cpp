#include "io/record_storage.h"

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

Record::Record(std::shared_ptr<const Storage> storage) : storage_(std::move(storage)) {}

Record::Record(RecordBuilder builder) {
  auto storage = std::make_shared<Storage>();
  storage->decoded = std::move(builder);
  storage_ = std::move(storage);
}

bool Record::known() const { return storage_->decoded.has_value(); }
Kind Record::which() const { return reader().which(); }
schema::Record::Reader Record::reader() const { return storage_->decoded->reader(); }
const std::string& Record::input() const { return storage_->input; }
const std::string& Record::place() const { return storage_->place; }

}  // namespace obby::io
