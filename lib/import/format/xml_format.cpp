// Reads the parsed file in two passes: the items first, because references may point forward; then
// their properties.
#include "import/format/xml_format.h"

#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "import/format/document_builder.h"
#include "import/format/xml_filter.h"
#include "import/format/xml_values.h"
#include "io/base64.h"
#include "io/text.h"

namespace obby::importer {
namespace {

class XmlReader {
 public:
  explicit XmlReader(std::string_view source) : source_(source), builder_(source.size()) {}

  Result<Document> read(const std::string& file) {
    FilteredXml filtered = filterXml(source_);
    if (filtered.replaced > 0) {
      builder_.warn(io::plural(filtered.replaced, "forbidden XML character reference") +
                    " replaced");
    }
    pugi::xml_document xml;
    const pugi::xml_parse_result parsed = xml.load_buffer_inplace(
        filtered.text.data(), filtered.text.size(),
        pugi::parse_cdata | pugi::parse_escapes | pugi::parse_ws_pcdata_single,
        pugi::encoding_utf8);
    if (!parsed) return at(parsed.offset, "XML", lowerFirst(parsed.description()));
    const pugi::xml_node root = xml.child("roblox");
    if (!root) return at(0, "XML", "expected the element <roblox>");
    OBBY_RETURN_IF_ERROR(readSharedStrings(root));
    OBBY_RETURN_IF_ERROR(readItems(root));
    for (const auto& [item, id] : items_) OBBY_RETURN_IF_ERROR(readProperties(item, id));
    return builder_.finish(file, false);
  }

 private:
  Status readSharedStrings(pugi::xml_node root) {
    for (const pugi::xml_node list : root.children("SharedStrings")) {
      for (const pugi::xml_node entry : list.children("SharedString")) {
        auto bytes = io::decodeBase64(textOf(entry));
        if (!bytes) return at(startOf(entry), "SharedString", "expected base64");
        context_.sharedStrings.emplace(entry.attribute("md5").value(),
                                       std::make_shared<const std::string>(std::move(*bytes)));
      }
    }
    return {};
  }

  Status readItems(pugi::xml_node root) {
    struct Level {
      pugi::xml_node next;  // item to visit
      InstanceId parent;
    };
    std::vector<Level> stack = {{root.child("Item"), kNoInstance}};
    while (!stack.empty()) {
      const pugi::xml_node item = stack.back().next;
      if (!item) {
        stack.pop_back();
        continue;
      }
      if (stack.size() > kMaxInstanceDepth) {
        return at(startOf(item), "Item",
                  "instances are nested deeper than " + std::to_string(kMaxInstanceDepth));
      }
      stack.back().next = item.next_sibling("Item");
      OBBY_ASSIGN(const InstanceId id, addItem(item, stack.back().parent));
      stack.push_back({item.child("Item"), id});
    }
    return {};
  }

  Result<InstanceId> addItem(pugi::xml_node item, InstanceId parent) {
    const std::string_view className = item.attribute("class").value();
    if (className.empty()) return at(startOf(item), "Item", "the item has no class");
    const InstanceId id = builder_.add(std::string(className));
    if (builder_.overBudget()) return at(startOf(item), builder_.budgetError());
    builder_.setParent(id, parent);
    items_.emplace_back(item, id);
    const std::string_view referent = item.attribute("referent").value();
    if (!referent.empty() && !context_.instances.emplace(referent, id).second) {
      builder_.warn("referent '" + std::string(referent) + "' occurs twice; the first one counts");
    }
    return id;
  }

  Status readProperties(pugi::xml_node item, InstanceId id) {
    for (const pugi::xml_node list : item.children("Properties")) {
      for (const pugi::xml_node element : list.children()) {
        if (element.type() != pugi::node_element) continue;
        OBBY_RETURN_IF_ERROR(readProperty(element, id));
      }
    }
    return {};
  }

  Status readProperty(pugi::xml_node element, InstanceId id) {
    const std::string_view name = element.attribute("name").value();
    const std::string& className = builder_.classOf(id);
    const PropertyPlan& plan = builder_.planOf(className, name);
    if (plan.spelling.name.empty()) return {};
    // An older spelling may have another kind, which the element's name states.
    const Value* standard = plan.spelling.legacy ? nullptr : plan.standard;
    Result<Value> value = readXmlValue(element, standard, context_);
    if (!value) {
      Error error = std::move(value).error();
      error.path =
          className + "." + std::string(name) + (error.path.empty() ? "" : "." + error.path);
      return at(startOf(element), std::move(error));
    }
    if (!builder_.set(id, name, *std::move(value))) {
      return at(startOf(element), builder_.budgetError());
    }
    return {};
  }

  // pugixml returns the offset after the '<'.
  static ptrdiff_t startOf(pugi::xml_node element) { return element.offset_debug() - 1; }
  Error at(ptrdiff_t offset, Error error) const {
    error.place = "byte " + std::to_string(sourceOffset(source_, offset < 0 ? 0 : offset));
    return error;
  }
  Error at(ptrdiff_t offset, std::string path, std::string message) const {
    return at(offset, Error{{}, {}, std::move(path), std::move(message), {}});
  }
  static std::string lowerFirst(std::string text) {
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z')
      text[0] = static_cast<char>(text[0] | 0x20);
    return text;
  }

  std::string_view source_;
  DocumentBuilder builder_;
  XmlContext context_;
  std::vector<std::pair<pugi::xml_node, InstanceId>> items_;
};

// Skips white space, a byte order mark, declarations and comments.
std::string_view withoutProlog(std::string_view text) {
  text = io::withoutByteOrderMark(text);
  for (;;) {
    const size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    const bool comment = text.substr(0, 4) == "<!--";
    if (!comment && text.substr(0, 2) != "<?") return text;
    const std::string_view close = comment ? "-->" : "?>";
    const size_t end = text.find(close);
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + close.size());
  }
}

}  // namespace

bool looksLikeXml(std::string_view bytes) {
  const std::string_view text = withoutProlog(bytes);
  constexpr std::string_view kRoot = "<roblox";
  if (text.substr(0, kRoot.size()) != kRoot) return false;
  const char next = text.size() > kRoot.size() ? text[kRoot.size()] : ' ';
  return next == ' ' || next == '>' || next == '\t' || next == '\r' || next == '\n';
}

Result<Document> readXml(std::string_view bytes, const std::string& file) {
  Result<Document> document = XmlReader(bytes).read(file);
  if (document) return document;
  Error error = std::move(document).error();
  error.input = file;
  return error;
}

}  // namespace obby::importer
