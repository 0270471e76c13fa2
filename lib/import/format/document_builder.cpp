// Normalises the output of the format readers, and orders the tree.
#include "import/format/document_builder.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/format/attributes.h"
#include "import/format/studio_place.h"
#include "io/text.h"

namespace obby::importer {
namespace {

// A document may take this much memory plus a multiple of the file's size. That is enough for
// places of generated, well compressing parts (20 bytes each), and too little for files made to
// exhaust memory.
constexpr size_t kBaseBudget = size_t{48} << 20;
constexpr size_t kBudgetPerByte = 64;
constexpr size_t kMaxWarnings = 100;
constexpr size_t kMaxName = 100;  // characters; the engine's own limit
constexpr size_t kMaxNameBytes = 4 * kMaxName;
constexpr size_t kMaxProperties = 1000;  // per instance; engine classes have < 200
constexpr std::string_view kServices[] = {
    "Workspace",     "Lighting",   "Players",     "StarterPlayer",      "ReplicatedStorage",
    "ServerStorage", "StarterGui", "StarterPack", "ServerScriptService"};

// Returns the bytes of a property that files store as a plain or a shared string; null for others.
const std::string* bytesOf(const Value& value) {
  if (const auto* shared = std::get_if<SharedBlob>(&value)) return shared->bytes.get();
  return std::get_if<std::string>(&value);
}

size_t cost(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  const auto* item = std::get_if<EnumItem>(&value);
  return sizeof(std::pair<std::string, Value>) + (text ? text->size() : 0) +
         (item ? item->type.size() : 0);
}

// Returns true for equal values of the kinds that most parts have; false for all other kinds.
bool sameValue(const Value& a, const Value& b) {
  if (a.index() != b.index()) return false;
  if (const auto* v = std::get_if<bool>(&a)) return *v == std::get<bool>(b);
  if (const auto* v = std::get_if<int64_t>(&a)) return *v == std::get<int64_t>(b);
  if (const auto* v = std::get_if<double>(&a)) return *v == std::get<double>(b);
  if (const auto* v = std::get_if<std::string>(&a)) return *v == std::get<std::string>(b);
  if (const auto* v = std::get_if<EnumItem>(&a)) return v->value == std::get<EnumItem>(b).value;
  if (const auto* v = std::get_if<Vec3>(&a)) return *v == std::get<Vec3>(b);
  if (const auto* v = std::get_if<CFrame>(&a)) {
    const CFrame& other = std::get<CFrame>(b);
    const Mat3 &m = v->rotation, &n = other.rotation;
    return v->position == other.position && m.x == n.x && m.y == n.y && m.z == n.z;
  }
  const auto* physics = std::get_if<PhysicalProperties>(&a);
  return physics != nullptr && !physics->custom && !std::get<PhysicalProperties>(b).custom;
}

// Returns how many bytes of the name are kept. No character is cut in two.
size_t nameSize(std::string_view name) {
  if (name.size() <= kMaxName) return name.size();
  size_t at = 0, characters = 0;
  for (; at < name.size() && at < kMaxNameBytes; ++at) {
    const bool begins = (static_cast<unsigned char>(name[at]) & 0xc0) != 0x80;
    if (begins && ++characters > kMaxName) break;
  }
  return at;
}

// Returns the bytes of memory that a blob of tags needs once decoded. Each tag becomes a string,
// even a short one.
size_t costOfTags(const std::string& blob) {
  constexpr size_t kEach = 3 * sizeof(std::string);  // for the instance and the tag index
  const auto breaks = static_cast<size_t>(std::count(blob.begin(), blob.end(), '\0'));
  return 2 * blob.size() + kEach * (blob.empty() ? 0 : breaks + 1);
}

bool isService(const std::string& className) {
  return std::find(std::begin(kServices), std::end(kServices), className) != std::end(kServices);
}

}  // namespace

DocumentBuilder::DocumentBuilder(size_t inputBytes)
    : budget_(kBaseBudget + kBudgetPerByte * inputBytes) {}

InstanceId DocumentBuilder::add(std::string className) {
  used_ += sizeof(Instance) + className.size() + 2 * sizeof(InstanceId);
  document_.instances.emplace_back().className = std::move(className);
  return static_cast<InstanceId>(document_.instances.size() - 1);
}

bool DocumentBuilder::set(InstanceId id, std::string_view name, Value value) {
  Instance& instance = document_.instances[id];
  if (overBudget()) return false;
  if (name == "Name") {
    if (const std::string* text = bytesOf(value)) {
      const size_t size = nameSize(*text);
      if (size < text->size()) ++cutNames_;
      instance.name.assign(*text, 0, size);
    }
    used_ += instance.name.size();
    return !overBudget();
  }
  if (name == "Tags") {
    if (const std::string* blob = bytesOf(value)) {
      used_ += costOfTags(*blob);
      if (overBudget()) return false;
      instance.tags = decodeTags(*blob);
    }
    return !overBudget();
  }
  if (name == "AttributesSerialize") {
    if (const std::string* blob = bytesOf(value)) setAttributes(id, *blob);
    return !overBudget();
  }
  const PropertyPlan& plan = planOf(instance.className, name);
  const PropertySpelling& spelling = plan.spelling;
  if (spelling.name.empty()) return true;
  if (spelling.legacy && instance.properties.contains(spelling.name)) return true;
  if (plan.standard != nullptr) value = normalisedValue(*plan.standard, std::move(value));
  if (plan.dropStandard && sameValue(value, *plan.standard) &&
      !instance.properties.contains(spelling.name)) {
    return true;
  }
  if (instance.properties.size() >= kMaxProperties) return true;
  used_ += cost(value);
  instance.properties[spelling.name] = std::move(value);
  return !overBudget();
}

const PropertyPlan& DocumentBuilder::planOf(const std::string& className, std::string_view name) {
  std::string key = className + '\n';
  key += name;
  const auto known = plans_.find(key);
  if (known != plans_.end()) return known->second;
  used_ += key.size() + sizeof(PropertyPlan) + 2 * sizeof(std::string);
  PropertyPlan plan;
  plan.spelling = spellingOf(className, name);
  plan.standard = defaultOf(className, plan.spelling.name);
  // Places have tens of thousands of parts, so their defaults are dropped. Their colour is kept: an
  // older spelling must not replace it.
  plan.dropStandard = plan.standard != nullptr && isA(className, "BasePart");
  return plans_.emplace(std::move(key), std::move(plan)).first->second;
}

void DocumentBuilder::setAttributes(InstanceId id, std::string_view blob) {
  Instance& instance = document_.instances[id];
  used_ += blob.size();
  if (overBudget()) return;
  DecodedAttributes decoded = decodeAttributes(blob);
  for (const auto& [key, value] : decoded.values) used_ += key.size() + cost(value) + 64;
  instance.attributes = std::move(decoded.values);
  if (decoded.warning.empty()) return;
  if (attributeWarnings_.size() < kMaxWarnings) {
    attributeWarnings_.emplace_back(id, std::move(decoded.warning));
  } else {
    ++droppedWarnings_;
  }
}

void DocumentBuilder::warnOfAttributes() {
  for (const auto& [id, warning] : attributeWarnings_) {
    const Instance& instance = document_.instances[id];
    warn(instance.className + " '" + instance.name + "': " + warning);
  }
}

void DocumentBuilder::setAttribute(InstanceId id, std::string name, Value value) {
  used_ += name.size() + cost(value) + 64;
  if (!overBudget()) document_.instances[id].attributes[std::move(name)] = std::move(value);
}

void DocumentBuilder::become(InstanceId id, std::string className) {
  document_.instances[id].className = std::move(className);
}

std::vector<InstanceId> DocumentBuilder::graft(Document&& document) {
  const auto first = static_cast<InstanceId>(size());
  const auto shift = [first](InstanceId& id) { id = id == kNoInstance ? id : id + first; };
  for (Instance& instance : document.instances) {
    used_ += sizeof(Instance) + instance.className.size() + 2 * sizeof(InstanceId);
    shift(instance.parent);
    for (InstanceId& child : instance.children) shift(child);
    for (auto& [name, value] : instance.properties) {
      used_ += cost(value);
      if (auto* ref = std::get_if<Ref>(&value)) shift(ref->target);
    }
    for (const auto& [name, value] : instance.attributes) used_ += name.size() + cost(value) + 64;
    document_.instances.push_back(std::move(instance));
  }
  for (std::string& warning : document.warnings) warn(document.file + ": " + warning);
  for (InstanceId& root : document.roots) shift(root);
  return std::move(document.roots);
}

void DocumentBuilder::allow(size_t inputBytes) { budget_ += kBudgetPerByte * inputBytes; }

void DocumentBuilder::setParent(InstanceId child, InstanceId parent) {
  document_.instances[child].parent = parent;
  auto& siblings = parent == kNoInstance ? document_.roots : document_.instances[parent].children;
  siblings.push_back(child);
}

void DocumentBuilder::warn(std::string warning) {
  if (document_.warnings.size() < kMaxWarnings) {
    document_.warnings.push_back(std::move(warning));
  } else {
    ++droppedWarnings_;
  }
}

Error DocumentBuilder::budgetError() const {
  return makeError("the content is too large for a file of this size: more than " +
                   std::to_string(budget_ >> 20) + " MiB");
}

// `order` has parents before children, so a parent's depth is known before its children's.
Status DocumentBuilder::checkDepth(const std::vector<InstanceId>& order) const {
  std::vector<uint32_t> depth(document_.instances.size(), 1);
  for (const InstanceId id : order) {
    const InstanceId parent = document_.instances[id].parent;
    if (parent != kNoInstance) depth[id] = depth[parent] + 1;
    if (depth[id] > kMaxInstanceDepth) {
      return makeError("instances are nested deeper than " + std::to_string(kMaxInstanceDepth));
    }
  }
  return {};
}

Result<Document> DocumentBuilder::finish(std::string file, bool binary) {
  warnOfAttributes();
  unpackStudioPlace(document_);
  std::vector<Instance>& old = document_.instances;
  std::vector<InstanceId> order, stack(document_.roots.rbegin(), document_.roots.rend());
  order.reserve(old.size());
  while (!stack.empty()) {
    const InstanceId id = stack.back();
    stack.pop_back();
    order.push_back(id);
    stack.insert(stack.end(), old[id].children.rbegin(), old[id].children.rend());
  }
  if (order.size() < old.size()) {
    return makeError(io::plural(old.size() - order.size(), "instance") + " in a cycle of parents");
  }
  OBBY_RETURN_IF_ERROR(checkDepth(order));

  std::vector<InstanceId> newId(old.size());
  for (size_t i = 0; i < order.size(); ++i) newId[order[i]] = static_cast<InstanceId>(i);
  const auto translate = [&newId](InstanceId& id) {
    id = id < newId.size() ? newId[id] : kNoInstance;
  };
  std::vector<Instance> sorted;
  sorted.reserve(old.size());
  for (const InstanceId id : order) {
    Instance& instance = sorted.emplace_back(std::move(old[id]));
    translate(instance.parent);
    for (InstanceId& child : instance.children) translate(child);
    for (auto& [name, value] : instance.properties) {
      if (auto* ref = std::get_if<Ref>(&value)) translate(ref->target);
    }
    instance.properties.compact();
  }
  old = std::move(sorted);
  bool place = false;
  for (InstanceId& root : document_.roots) {
    translate(root);
    place = place || isService(old[root].className);
  }
  document_.file = std::move(file);
  document_.format = std::string(place ? "rbxl" : "rbxm") + (binary ? "" : "x");
  if (cutNames_ > 0) {
    document_.warnings.push_back(io::plural(cutNames_, "name") + " cut to " +
                                 std::to_string(kMaxName) + " characters, as in the engine");
  }
  if (droppedWarnings_ > 0) {
    document_.warnings.push_back("and " + io::plural(droppedWarnings_, "more warning"));
  }
  return std::move(document_);
}

}  // namespace obby::importer
