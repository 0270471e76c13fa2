// One record of a stream in memory. Owns its bytes; cheap to move, not to copy.
#pragma once

#include <capnp/message.h>

#include <memory>
#include <string>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::io {

using Kind = schema::Record::Which;

// A record being built or changed: `auto level = builder.root().initLevel();`
class RecordBuilder {
 public:
  RecordBuilder() : message_(std::make_unique<capnp::MallocMessageBuilder>()) {
    message_->initRoot<schema::Record>();
  }
  // A copy of an existing record, to change it.
  explicit RecordBuilder(schema::Record::Reader from)
      : message_(std::make_unique<capnp::MallocMessageBuilder>()) {
    message_->setRoot(from);
  }
  schema::Record::Builder root() { return message_->getRoot<schema::Record>(); }
  schema::Record::Reader reader() { return message_->getRoot<schema::Record>().asReader(); }

 private:
  std::unique_ptr<capnp::MallocMessageBuilder> message_;
};

// A record as read. `known()` is false for a kind that this version's schema does not have; such a
// record can only be passed through.
class Record {
 public:
  struct Storage;  // the decoded message and, for pass-through, the bytes it came from
  explicit Record(std::shared_ptr<const Storage> storage);

  bool known() const;
  Kind which() const;  // only if known()
  schema::Record::Reader reader()
      const;                         // only if known(); valid while any copy of this Record lives
  const std::string& place() const;  // "12" or "byte 4711": for error messages
  const Storage& storage() const { return *storage_; }

 private:
  std::shared_ptr<const Storage> storage_;
};

}  // namespace obby::io
