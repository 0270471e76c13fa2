#include "io/normal_form.h"

#include <cstring>

namespace obby::io {
namespace {

using Reader = capnp::DynamicStruct::Reader;
using Builder = capnp::DynamicStruct::Builder;

class Copier {
 public:
  Error error;

  bool fields(const StructPlan& plan, Reader in, Builder out, const Path& path) {
    for (const FieldPlan& field : plan.fields)
      if (isSet(field, in) && !copy(field, in, out, Path{&path, field.name})) return false;
    return true;
  }

 private:
  bool copy(const FieldPlan& field, Reader in, Builder out, const Path& path) {
    const TypePlan& type = field.type;
    const auto value = in.get(field.field);
    if (auto wrong = refuseScalar(type, value)) return fail(path, *wrong);
    if (type.kind == ValueKind::record) {
      if (!budget_.take(type.record->words())) return fail(path, WordBudget::kMessage);
      return fields(*type.record, value.as<capnp::DynamicStruct>(),
                    out.init(field.field).as<capnp::DynamicStruct>(), path);
    }
    if (type.kind == ValueKind::list) {
      const auto list = value.as<capnp::DynamicList>();
      if (!budget_.take(listWords(type.element[0], list.size())))
        return fail(path, WordBudget::kMessage);
      return elements(type.element[0], list,
                      out.init(field.field, list.size()).as<capnp::DynamicList>(), path);
    }
    if (type.kind == ValueKind::text) {
      const auto text = value.as<capnp::Text>();
      if (!budget_.take(textWords(text.size()))) return fail(path, WordBudget::kMessage);
      setText(out.init(field.field, uint32_t(text.size())), text);
      return true;
    }
    out.set(field.field, value);
    return true;
  }

  bool elements(const TypePlan& element, capnp::DynamicList::Reader in,
                capnp::DynamicList::Builder out, const Path& path) {
    for (uint32_t i = 0; i < in.size(); i++) {
      const Path here{&path, {}, int64_t(i)};
      const auto value = in[i];
      if (auto wrong = refuseScalar(element, value)) return fail(here, *wrong);
      if (element.kind == ValueKind::record) {
        if (!fields(*element.record, value.as<capnp::DynamicStruct>(),
                    out[i].as<capnp::DynamicStruct>(), here))
          return false;
      } else if (element.kind == ValueKind::text) {
        const auto text = value.as<capnp::Text>();
        if (text.size() == 0) continue;
        if (!budget_.take(textWords(text.size()))) return fail(here, WordBudget::kMessage);
        setText(out.init(i, uint32_t(text.size())), text);
      } else if (element.kind == ValueKind::list) {
        return fail(here, "the schema has no lists of lists");
      } else {
        out.set(i, value);
      }
    }
    return true;
  }

  static void setText(capnp::DynamicValue::Builder out, capnp::Text::Reader text) {
    std::memcpy(out.as<capnp::Text>().begin(), text.begin(), text.size());
  }

  bool fail(const Path& path, std::string message) {
    error = Error{{}, {}, path.text(), std::move(message), {}};
    return false;
  }

  WordBudget budget_;
};

const FieldPlan* kindOf(Reader in) {
  KJ_IF_MAYBE (kind, in.which()) return &recordPlan().fields[kind->getIndex()];
  return nullptr;
}

}  // namespace

Result<RecordBuilder> normalForm(schema::Record::Reader in, uint64_t words) {
  const Reader record(in);
  const FieldPlan* kind = kindOf(record);
  if (!kind) return makeError("cannot convert this record: this program does not know its type");
  // Apart from the kind, the copy has no more words than `in`.
  RecordBuilder out(1 + words + kind->type.record->words());
  Copier copier;
  const Builder root(out.root());
  // The kind counts as present even if its pointer is null.
  auto target = Builder(root).init(kind->field).as<capnp::DynamicStruct>();
  if (!copier.fields(*kind->type.record, record.get(kind->field).as<capnp::DynamicStruct>(), target,
                     Path{}))
    return std::move(copier.error);
  return out;
}

Error unsoundMessage(const kj::Exception& exception) {
  std::string what = exception.getDescription().cStr();
  if (const size_t code = what.rfind("; "); code != std::string::npos) what.erase(0, code + 2);
  what = what.substr(0, what.find(".  "));  // cuts off the advice for programmers that follows
  if (what.ends_with('.')) what.pop_back();
  return makeError("invalid Cap'n Proto message: " + what);
}

}  // namespace obby::io
