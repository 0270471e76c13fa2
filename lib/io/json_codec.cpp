#include "io/json_codec.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/spelling.h"
#include "io/json_decode.h"
#include "io/json_encode.h"
#include "io/text.h"

namespace obby::io {
namespace {

constexpr std::string_view kTypeMember = "type";

Error noType(std::string found, std::string hint = {}) {
  return Error{
      {},
      {},
      std::string(kTypeMember),
      fmt::format("expected one of {}, found {}", fmt::join(recordPlan().names(), ", "), found),
      std::move(hint)};
}

// Returns the text of the member `type`.
Result<std::string_view> typeOf(const JsonTree& tree) {
  if (tree.root().type != JsonTree::Type::object)
    return makeError(fmt::format("expected a record such as {{\"type\":\"level\"}}, found {}",
                                 tree.describe(tree.root())));
  const JsonTree::Node* found = nullptr;
  for (const JsonTree::Node& member : tree.children(tree.root())) {
    if (tree.name(member) != kTypeMember) continue;
    if (found) return Error{{}, {}, std::string(kTypeMember), "the field is given twice", {}};
    found = &member;
  }
  if (!found) return noType("none");
  if (found->type != JsonTree::Type::text) return noType(tree.describe(*found));
  return tree.text(*found);
}

// Returns an empty hint if no kind has a similar name.
std::string hintFor(std::string_view type) {
  const std::string near = nearestName(type, recordPlan().names());
  return near.empty() ? near : fmt::format("did you mean \"{}\"?", near);
}

}  // namespace

bool endsInside(const Error& error) { return error.message.ends_with(JsonTree::kCutOff); }

Result<std::optional<RecordBuilder>> recordFromJsonIfKnown(std::string_view line,
                                                           std::vector<Error>* misspelt) {
  OBBY_ASSIGN(const JsonTree tree, JsonTree::parse(line));
  OBBY_ASSIGN(const std::string_view type, typeOf(tree));
  const FieldPlan* kind = recordPlan().find(type);
  if (!kind) {
    std::string hint = misspelt == nullptr ? std::string() : hintFor(type);
    if (!hint.empty()) return noType(quoted(type), std::move(hint));
    return std::optional<RecordBuilder>();
  }
  RecordBuilder out(std::min<uint64_t>(line.size() / 8 + 64, kMaxMessageWords));
  JsonDecoder decoder(tree, misspelt);
  capnp::DynamicStruct::Builder root(out.root());
  auto target = root.init(kind->field).as<capnp::DynamicStruct>();
  if (!decoder.fill(*kind->type.record, target, tree.root(), Path{}, kTypeMember))
    return std::move(decoder.error);
  return std::optional<RecordBuilder>(std::move(out));
}

Result<RecordBuilder> recordFromJson(std::string_view line) {
  OBBY_ASSIGN(std::optional<RecordBuilder> record, recordFromJsonIfKnown(line));
  if (record) return std::move(*record);
  OBBY_ASSIGN(const JsonTree tree, JsonTree::parse(line));
  OBBY_ASSIGN(const std::string_view type, typeOf(tree));
  return noType(quoted(type), hintFor(type));
}

Result<std::string> recordToJson(schema::Record::Reader record) {
  JsonEncoder encoder;
  if (!encoder.record(capnp::DynamicStruct::Reader(record))) return std::move(encoder.error);
  return encoder.out.finish();
}

}  // namespace obby::io
