// The reading half of the JSON codec. Private to lib/io.
#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "io/checks.h"
#include "io/json_tree.h"
#include "io/path.h"
#include "io/schema_plan.h"

namespace obby::io {

// Fills one message from one JSON tree. Every member function returns false after an error, which
// `error` then holds.
class JsonDecoder {
 public:
  // recordFromJsonIfKnown() explains `misspelt`.
  JsonDecoder(const JsonTree& tree, std::vector<Error>* misspelt)
      : tree_(tree), misspelt_(misspelt) {}

  using Node = JsonTree::Node;
  using Value = capnp::DynamicValue::Reader;

  // Sets the fields of `out` from the members of an object. `skip` names a member to ignore.
  bool fill(const StructPlan& plan, capnp::DynamicStruct::Builder out, const Node& node,
            const Path& path, std::string_view skip = {});

  Error error;

 private:
  static constexpr size_t kMaxTuple = 8;
  using Tuple = std::array<Value, kMaxTuple>;

  bool field(const FieldPlan& plan, capnp::DynamicStruct::Builder out, const Node& node,
             const Path& path);
  bool tupleField(const FieldPlan& plan, capnp::DynamicStruct::Builder out, const Node& node,
                  const Path& path);
  bool readTuple(const StructPlan& plan, const Node& node, const Path& path, Tuple& out);
  bool list(const TypePlan& element, capnp::DynamicList::Builder out, const Node& node,
            const Path& path);
  bool elementValue(const TypePlan& element, capnp::DynamicList::Builder out, uint32_t index,
                    const Node& node, const Path& path);
  bool scalar(const TypePlan& type, const Node& node, const Path& path, Value& out);
  bool whole(const TypePlan& type, const Node& node, const Path& path, Value& out);
  bool whole64(const TypePlan& type, const Node& node, const Path& path, Value& out);
  bool real(const TypePlan& type, const Node& node, const Path& path, Value& out);
  bool enumerant(const TypePlan& type, const Node& node, const Path& path, Value& out);
  bool take(uint64_t words, const Path& path);
  bool unexpected(const TypePlan& type, const Node& node, const Path& path);
  void passOver(const StructPlan& plan, const Path& path);
  bool fail(const Path& path, std::string message, std::string hint = {});

  const JsonTree& tree_;
  std::vector<Error>* misspelt_;
  std::set<std::pair<const StructPlan*, std::string>> strange_;  // unknown, and close to no field
  WordBudget budget_;
};

}  // namespace obby::io
