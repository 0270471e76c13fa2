// Adds the instances that the files of a Rojo project describe to a DocumentBuilder.
#pragma once

#include <string>
#include <string_view>

#include "import/format/document_builder.h"
#include "import/rojo/json_file.h"

namespace obby::importer::rojo {

// A place for errors: a file and the keys that lead to a value in it.
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

  // Adds an instance without a parent. Fails if the document is too large.
  Result<InstanceId> add(std::string className, std::string_view name, const Place& place);
  void rename(InstanceId id, std::string_view name) { builder_.set(id, "Name", std::string(name)); }
  const std::string& classOf(InstanceId id) const { return builder_.classOf(id); }

  // Sets properties or attributes from an object, by name. An absent object sets none. A value of
  // an unknown kind is left out, with a warning if a level can depend on it.
  Status setProperties(InstanceId id, const Json& object, const Place& place);
  Status setAttributes(InstanceId id, const Json& object, const Place& place);

  // Adds the instances of a .model.json: ClassName, Name, Properties, Attributes, Children. If
  // `name` is empty, the JSON decides.
  Result<InstanceId> addModel(const Json& model, std::string_view name, const Place& place,
                              int depth = 0);

 private:
  Status setProperty(InstanceId id, const std::string& name, const Json& value, const Place& place);

  DocumentBuilder& builder_;
};

}  // namespace obby::importer::rojo
