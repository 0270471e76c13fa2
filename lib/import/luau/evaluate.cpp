// Expressions of the script reader.
#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kCharsPerStep = 64;

// A default is worth its value to an assignment; as a condition it is not known.
Datum defaultOr(const Datum& value) { return value.as<bool>() ? Datum{} : value; }

}  // namespace

std::vector<Datum> Reader::evaluateAll(const std::vector<ExprPtr>& list, size_t from) {
  std::vector<Datum> values;
  for (size_t i = from; i < list.size(); ++i) values.push_back(evaluate(*list[i]));
  return values;
}

// A long text takes more steps: each value is a copy.
Datum Reader::evaluate(const Expr& expr) {
  if (!spend()) return {};
  Datum value = evaluated(expr);
  const auto* text = value.as<std::string>();
  if (text && !spend(text->size() / kCharsPerStep)) return {};
  return value;
}

Datum Reader::evaluated(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::nil:
    case ExprKind::truth:
    case ExprKind::falsehood:
    case ExprKind::number:
    case ExprKind::string: return literalOf(expr);
    case ExprKind::name: return nameValue(expr.text);
    case ExprKind::field: return field(evaluate(*expr.kids[0]), expr.text);
    case ExprKind::index: {
      const Datum object = evaluate(*expr.kids[0]);
      return indexed(object, evaluate(*expr.kids[1]));
    }
    case ExprKind::call: return callValue(expr);
    case ExprKind::method: return methodValue(expr);
    case ExprKind::function: return {Closure{expr.body.get(), scope_}};
    case ExprKind::table: return tableValue(expr);
    case ExprKind::binary: return binary(expr);
    case ExprKind::choice: {
      const Truth truth = truthOf(evaluate(*expr.kids[0]));
      if (truth != Truth::unknown) return evaluate(*expr.kids[truth == Truth::no ? 2 : 1]);
      const Datum yes = unsureValue(*expr.kids[1]);
      return oneOf(yes, unsureValue(*expr.kids[2]));
    }
    case ExprKind::unary: {
      const Datum value = evaluate(*expr.kids[0]);
      if (expr.text == "not") return datumOf(negated(truthOf(value)));
      if (expr.text == "-") return arithmetic("*", value, {-1.0});
      if (const auto* table = value.as<Table*>()) return {double((*table)->items.size())};
      if (const auto* text = value.as<std::string>(); text && expr.text == "#")
        return {double(text->size())};
      return {};
    }
    case ExprKind::vararg:
    case ExprKind::unknown: return {};
  }
  return {};
}

Datum Reader::nameValue(const std::string& name) {
  if (Scope* holder = scope_->holder(name))
    return variables_.get(holder->names, name, isOwn(holder->born));
  if (name == "workspace" || name == "Workspace") return serviceNamed("Workspace");
  if (name == "game" || name == "Game") return {Library{"game"}};
  return {Library{name}};
}

// What may not be evaluated: a call in it is under a condition.
Datum Reader::unsureValue(const Expr& expr) {
  ++unsure_;
  Datum value = evaluate(expr);
  --unsure_;
  return value;
}

Datum Reader::logical(const Expr& expr) {
  const Expr &before = *expr.kids[0], &after = *expr.kids[1];
  const bool either = expr.text == "or";
  const bool chooses = either && before.kind == ExprKind::binary && before.text == "and";
  Datum left = evaluate(chooses ? *before.kids[0] : before);
  if (chooses && truthOf(left) == Truth::unknown) {  // `left and yes or no`
    const Datum yes = unsureValue(*before.kids[1]), no = unsureValue(after);
    const Truth truth = truthOf(yes);
    return truth == Truth::yes ? oneOf(yes, no) : truth == Truth::no ? no : defaultOr(no);
  }
  if (chooses && truthOf(left) == Truth::yes) left = evaluate(*before.kids[1]);
  const Truth truth = truthOf(left);
  if (truth == (either ? Truth::yes : Truth::no)) return left;
  if (truth != Truth::unknown) return evaluate(after);
  const Datum right = unsureValue(after);
  return either ? defaultOr(right) : Datum{};
}

Datum Reader::binary(const Expr& expr) {
  if (expr.text == "and" || expr.text == "or") return logical(expr);
  const Datum left = evaluate(*expr.kids[0]);
  const Datum right = evaluate(*expr.kids[1]);
  const char first = expr.text[0];
  if (first == '<' || first == '>' || first == '=' || first == '~')
    return compared(expr.text, left, right);
  return arithmetic(expr.text, left, right);
}

Datum Reader::tableValue(const Expr& expr) {
  auto table = arena_.make<Table>();
  table->born = followed_;
  variables_.make(table->fields);
  bool keyed = false;
  for (size_t i = 0; i < expr.kids.size(); ++i) {
    Datum value = evaluate(*expr.kids[i]);
    if (!expr.keys[i]) {
      // {folder:GetChildren()} spreads nothing here: a list stays one item.
      table->items.push_back(std::move(value));
      continue;
    }
    // Numbers and instances as keys are left out, so that at least all values are gone through. One
    // alone would be taken for what any key finds, as of `{[ownerId] = true}`.
    const Datum key = evaluate(*expr.keys[i]);
    if (const auto* name = key.as<std::string>())
      table->fields[*name] = std::move(value);
    else
      table->items.push_back(std::move(value));
    keyed = keyed || !key.as<std::string>();
  }
  if (keyed && table->items.size() == 1) table->items.clear();
  return {table};
}

Datum Reader::field(const Datum& object, const std::string& name) {
  if (const auto* ref = object.as<Ref>()) return instanceField(ref->target, name);
  if (const auto* library = object.as<Library>()) {
    if (library->name == "_G" || library->name == "shared") return {};  // of other scripts
    if (library->name == "game" || library->name == "workspace") return serviceNamed(name);
    if (isColor(object)) return colorField(*library, name);
    if (name == "Name" && library->name.rfind("Enum.", 0) == 0)
      return {library->name.substr(library->name.rfind('.') + 1)};
    return libraryField(library->name + "." + name);
  }
  if (const auto* table = object.as<Table*>())
    return variables_.get((*table)->fields, name, isOwn((*table)->born));
  if (const auto* made = object.as<Made*>()) return madeField(*made, name);
  if (const auto* tween = object.as<Tween*>()) {
    if (name == "Completed") return {Signal{kNoInstance, *tween, name}};
    return tweenField(*tween, name);
  }
  if (object.as<Vector>() || object.as<Frame>() || object.as<TweenTiming>())
    return valueMethod(object, name, {});
  if (object.as<Stranger>() || object.as<Unknown>()) return {Stranger{name}};
  return {};
}

Datum Reader::indexed(const Datum& object, const Datum& key) {
  if (const auto* name = key.as<std::string>()) return field(object, *name);
  const auto* table = object.as<Table*>();
  if (!table) return object.as<Stranger>() ? object : Datum{};
  const auto& items = (*table)->items;
  if (const auto* n = key.as<double>()) {
    const bool inside = *n >= 1 && *n <= double(items.size());
    return inside ? items[size_t(*n) - 1] : Datum{Nil{}};
  }
  return items.size() == 1 ? items[0] : Datum{};
}

}  // namespace obby::importer::luau
