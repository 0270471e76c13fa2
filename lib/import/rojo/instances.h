// Instances of a Rojo project in the making: what its files say of one goes into a DocumentBuilder.
#pragma once

#include <string>
#include <string_view>

#include "import/format/document_builder.h"
#include "import/rojo/json_file.h"

namespace obby::importer::rojo {

// For errors: a file and the keys that lead to a value in it.
struct Place {
  std::string file, keys;
  Place at(std::string_view key) const {
    return {file, keys.empty() ? std::string(key) : keys + '.' + std::string(key)};
  }
  Error error(std::string message, std::string hint = {}) const {
    return Error{file, {}, keys, std::move(message), std::move(hint)};
  }
};

class Instances {
 public:
  explicit Instances(DocumentBuilder& builder) : builder_(builder) {}

  // Without a parent yet. Error: the document is too large.
  Result<InstanceId> add(std::string className, std::string_view name, const Place& place);
  void rename(InstanceId id, std::string_view name) { builder_.set(id, "Name", std::string(name)); }
  const std::string& classOf(InstanceId id) const { return builder_.classOf(id); }

  // Objects of properties and of attributes, by name; no value: there are none. A value of a kind
  // that is not known is left out, with a warning if a level can depend on it.
  Status setProperties(InstanceId id, const Json& object, const Place& place);
  Status setAttributes(InstanceId id, const Json& object, const Place& place);

  // A .model.json: ClassName, Name, Properties, Attributes, Children. An empty `name` leaves it to
  // the JSON.
  Result<InstanceId> addModel(const Json& model, std::string_view name, const Place& place,
                              int depth = 0);

 private:
  Status setProperty(InstanceId id, const std::string& name, const Json& value, const Place& place);

  DocumentBuilder& builder_;
};

}  // namespace obby::importer::rojo
