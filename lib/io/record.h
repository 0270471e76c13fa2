// One record of a stream in memory. It owns its bytes, and is cheap to move and to share, but not
// to copy.
#pragma once

#include <capnp/message.h>

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::io {

using Kind = schema::Record::Which;

// The memory of a record that is being built. If none is left it throws std::bad_alloc, as other
// code does, instead of an exception of Cap'n Proto that names its source code.
class RecordMemory final : public capnp::MallocMessageBuilder {
 public:
  using MallocMessageBuilder::MallocMessageBuilder;
  kj::ArrayPtr<capnp::word> allocateSegment(unsigned int minimumWords) override;
};

// A record being built or changed: `auto level = builder.root().initLevel();`. Throws
// std::bad_alloc if there is no memory for it.
class RecordBuilder {
 public:
  RecordBuilder() : RecordBuilder(uint64_t(1024)) {}
  // Reserves memory for that many words.
  explicit RecordBuilder(uint64_t firstWords)
      : message_(std::make_unique<RecordMemory>(uint32_t(firstWords))) {
    message_->initRoot<schema::Record>();
  }
  // Copies an existing record, to change it.
  explicit RecordBuilder(schema::Record::Reader from) : message_(std::make_unique<RecordMemory>()) {
    message_->setRoot(from);
  }
  schema::Record::Builder root() { return message_->getRoot<schema::Record>(); }
  schema::Record::Reader reader() const { return message_->getRoot<schema::Record>().asReader(); }
  capnp::MessageBuilder& message() { return *message_; }

 private:
  std::unique_ptr<RecordMemory> message_;
};

// A record as read. `known()` is false for a kind that this version's schema does not have, and for
// a record that could not be read; both can only be passed through. Everything reachable from
// reader() was checked on reading: numbers are finite and in range, texts are UTF-8, no access
// throws.
class Record {
 public:
  struct Storage;  // the decoded message and, for pass-through, the bytes it came from
  explicit Record(std::shared_ptr<const Storage> storage);
  // A record made by this program, as if it had been read.
  explicit Record(RecordBuilder builder);

  bool known() const;
  Kind which() const;                     // only if known()
  schema::Record::Reader reader() const;  // only if known(); valid while a copy of this lives
  // For error messages: input() is the input that the record was read from, and place() is "12" or
  // "byte 4711". Both are empty for a record made here.
  const std::string& input() const;
  const std::string& place() const;
  const Storage& storage() const { return *storage_; }

 private:
  std::shared_ptr<const Storage> storage_;
};

}  // namespace obby::io
