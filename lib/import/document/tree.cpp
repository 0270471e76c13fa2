// Navigates a Document. It has no knowledge of levels.
#include "import/document/tree.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "import/document/classes.h"
#include "io/text.h"

namespace obby::importer {
namespace {

bool equalNoCase(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return std::tolower(static_cast<unsigned char>(x)) ==
                  std::tolower(static_cast<unsigned char>(y));
         });
}

constexpr size_t kLongestPath = 1000;  // approximate max bytes
constexpr size_t kKeptOfPath = 400;    // bytes kept of a longer path's beginning

}  // namespace

bool containsWord(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

std::optional<int> firstNumber(std::string_view text) {
  const size_t at = text.find_first_of("0123456789");
  if (at == std::string_view::npos) return std::nullopt;
  int value = 0;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  (void)end;
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<double> numberFrom(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* whole = std::get_if<int64_t>(&value)) return double(*whole);
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return std::nullopt;
  const std::string_view digits = io::trimmed(*text);
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.empty())
    return std::nullopt;
  return number;
}

Tree::Tree(const Document& document)
    : document_(&document), siblingIndex_(document.instances.size()) {
  for (uint32_t i = 0; i < document.roots.size(); ++i) {
    const InstanceId id = document.roots[i];
    siblingIndex_[id] = i;
    services_.try_emplace(at(id).className, id);
    roots_.try_emplace(at(id).name, id);
  }
  for (InstanceId id = 0; id < document.instances.size(); ++id) {
    const auto& children = document.instances[id].children;
    for (uint32_t i = 0; i < children.size(); ++i) siblingIndex_[children[i]] = i;
    for (const auto& tag : document.instances[id].tags) byTag_[tag].push_back(id);
  }
}

InstanceId Tree::service(std::string_view className) const {
  const auto found = services_.find(className);
  return found == services_.end() ? kNoInstance : found->second;
}

InstanceId Tree::rootNamed(std::string_view name) const {
  const auto found = roots_.find(name);
  return found == roots_.end() ? kNoInstance : found->second;
}

std::vector<InstanceId> Tree::worldRoots() const {
  const InstanceId workspace = service("Workspace");
  if (workspace != kNoInstance) return {workspace};
  return document_->roots;
}

InstanceId Tree::child(InstanceId parent, std::string_view name) const {
  for (InstanceId id : at(parent).children)
    if (at(id).name == name) return id;
  return kNoInstance;
}

InstanceId Tree::childOfClass(InstanceId parent, std::string_view className) const {
  for (InstanceId id : at(parent).children)
    if (at(id).className == className) return id;
  return kNoInstance;
}

bool Tree::isUnder(InstanceId id, InstanceId ancestor) const {
  for (; id != kNoInstance; id = at(id).parent)
    if (id == ancestor) return true;
  return false;
}

bool Tree::isPart(InstanceId id) const { return isPartClass(at(id).className); }

void Tree::eachBelow(InstanceId root, const std::function<bool(InstanceId)>& visit) const {
  std::vector<InstanceId> open = {root};
  while (!open.empty()) {
    const InstanceId id = open.back();
    open.pop_back();
    if (!visit(id)) continue;
    const auto& children = at(id).children;
    open.insert(open.end(), children.rbegin(), children.rend());
  }
}

std::vector<InstanceId> Tree::partsOf(InstanceId id) const {
  if (isPart(id)) return {id};
  std::vector<InstanceId> parts;
  eachBelow(id, [&](InstanceId below) {
    if (isPart(below)) parts.push_back(below);
    return true;
  });
  return parts;
}

const std::vector<InstanceId>& Tree::tagged(const std::string& tag) const {
  static const std::vector<InstanceId> kNone;
  const auto it = byTag_.find(tag);
  return it == byTag_.end() ? kNone : it->second;
}

std::string Tree::path(InstanceId id) const {
  std::vector<InstanceId> chain;
  for (; id != kNoInstance; id = at(id).parent) chain.push_back(id);
  std::reverse(chain.begin(), chain.end());
  size_t size = 0;
  for (InstanceId step : chain) size += at(step).name.size() + 1;
  std::string text;
  const size_t tooMuch = size > kLongestPath ? size - kLongestPath : 0;
  size_t left = 0;  // bytes omitted: names in the middle
  for (size_t i = 0; i < chain.size(); ++i) {
    const std::string& name = at(chain[i]).name;
    const bool between = text.size() >= kKeptOfPath && i + 1 < chain.size();
    if (between && left < tooMuch) {
      if (left == 0) text += "/...";
      left += name.size() + 1;
      continue;
    }
    if (!text.empty()) text += '/';
    text += name;
  }
  return text;
}

std::vector<uint32_t> Tree::indices(InstanceId id) const {
  std::vector<uint32_t> chain;
  for (; id != kNoInstance; id = at(id).parent) chain.push_back(siblingIndex_[id]);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

const Value* Tree::settingHere(InstanceId id, std::string_view name) const {
  for (const auto& [key, value] : at(id).attributes)
    if (equalNoCase(key, name)) return &value;
  for (InstanceId child : at(id).children) {
    if (!isValueClass(at(child).className) || !equalNoCase(at(child).name, name)) continue;
    const auto it = at(child).properties.find("Value");
    if (it != at(child).properties.end()) return &it->second;
  }
  return nullptr;
}

const Value* Tree::setting(InstanceId id, std::string_view name) const {
  if (const Value* value = settingHere(id, name)) return value;
  for (InstanceId child : at(id).children)
    if (at(child).className == "Configuration")
      if (const Value* value = settingHere(child, name)) return value;
  return nullptr;
}

std::optional<double> Tree::number(InstanceId id, std::string_view name) const {
  const Value* value = setting(id, name);
  if (!value) return std::nullopt;
  const auto number = numberFrom(*value);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::string> Tree::text(InstanceId id, std::string_view name) const {
  const Value* value = setting(id, name);
  if (const auto* text = value ? std::get_if<std::string>(value) : nullptr) return *text;
  return std::nullopt;
}

std::optional<bool> Tree::flag(InstanceId id, std::string_view name) const {
  const Value* value = setting(id, name);
  if (const auto* flag = value ? std::get_if<bool>(value) : nullptr) return *flag;
  return std::nullopt;
}

}  // namespace obby::importer
