#include "import/rojo/instances.h"

#include "engine/classes/class_defaults.h"
#include "import/rojo/property_values.h"

namespace obby::importer::rojo {
namespace {

constexpr int kMaxModelDepth = 64;

// Returns a member of a model, whose keys may begin with a capital or a small letter.
Json member(const Json& model, const char* capital, const char* small) {
  const Json value = model[capital];
  return value ? value : model[small];
}

}  // namespace

Result<InstanceId> Instances::add(std::string className, std::string_view name,
                                  const Place& place) {
  const InstanceId id = builder_.add(std::move(className));
  rename(id, name);
  if (!builder_.overBudget()) return id;
  Error error = builder_.budgetError();
  error.input = place.file;
  return error;
}

Status Instances::setProperties(InstanceId id, const Json& object, const Place& place) {
  if (!object) return {};
  if (!object.isObject()) return place.error("expected an object, found " + object.describe());
  for (const auto& [name, value] : object.members())
    OBBY_RETURN_IF_ERROR(setProperty(id, name, value, place.at(name)));
  return {};
}

Status Instances::setProperty(InstanceId id, const std::string& name, const Json& value,
                              const Place& place) {
  if (name == "Attributes")
    return setAttributes(id, value.isObject() && value["Attributes"] ? value["Attributes"] : value,
                         place);
  if (name == "Tags") {
    const Json tags = value.isObject() ? value["Tags"] : value;
    std::string joined;
    for (const auto& [none, tag] : tags.members()) joined += tag.text().value_or("") + '\0';
    builder_.set(id, name, joined);
    return {};
  }
  const std::string& className = builder_.classOf(id);
  auto parsed = propertyValue(className, name, value);
  if (parsed) {
    builder_.set(id, name, *std::move(parsed));
  } else if (defaultOf(className, spellingOf(className, name).name) != nullptr) {
    builder_.warn(place.error("ignored, as it cannot be read: " + value.describe()).text());
  }
  return {};
}

Status Instances::setAttributes(InstanceId id, const Json& object, const Place& place) {
  if (!object) return {};
  if (!object.isObject()) return place.error("expected an object, found " + object.describe());
  for (const auto& [name, value] : object.members()) {
    auto parsed = attributeValue(value);
    if (parsed)
      builder_.setAttribute(id, name, *std::move(parsed));
    else
      builder_.warn(
          place.at(name).error("ignored, as it cannot be read: " + value.describe()).text());
  }
  return {};
}

Result<InstanceId> Instances::addModel(const Json& model, std::string_view name, const Place& place,
                                       int depth) {
  if (!model.isObject()) return place.error("expected an object, found " + model.describe());
  if (depth > kMaxModelDepth) return place.error("instances are nested deeper than 64 levels");
  const auto className = member(model, "ClassName", "className").text();
  if (!className) return place.at("ClassName").error("expected the name of a class");
  const std::string own = member(model, "Name", "name").text().value_or(*className);
  OBBY_ASSIGN(const InstanceId id, add(*className, name.empty() ? own : name, place));
  OBBY_RETURN_IF_ERROR(
      setProperties(id, member(model, "Properties", "properties"), place.at("Properties")));
  OBBY_RETURN_IF_ERROR(
      setAttributes(id, member(model, "Attributes", "attributes"), place.at("Attributes")));
  size_t index = 0;
  for (const auto& [none, child] : member(model, "Children", "children").members()) {
    const Place at = place.at("Children[" + std::to_string(index++) + "]");
    OBBY_ASSIGN(const InstanceId below, addModel(child, {}, at, depth + 1));
    builder_.setParent(below, id);
  }
  return id;
}

}  // namespace obby::importer::rojo
