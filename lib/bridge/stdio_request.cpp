#include "bridge/stdio_request.h"

#include "bridge/json.h"
#include "io/base64.h"

namespace obby::bridge {
namespace {

using io::JsonTree;
using Node = JsonTree::Node;

struct LineReader {
  const JsonTree& tree;
  StdioRequest& out;
  std::string method, path;
  const char* bodyName = nullptr;

  Status member(std::string_view name, const Node& value) {
    if (name == "id") return id(value);
    if (name == "method") return text(value, "method", method);
    if (name == "path") return text(value, "path", path);
    if (name != "body" && name != "text" && name != "base64") {
      return unknownMember("", name, {"id", "method", "path", "body", "text", "base64"});
    }
    if (bodyName) return pathError(std::string(name), "the body is given twice");
    bodyName = "body";
    if (name == "text") return text(value, "text", out.body);
    if (name == "base64") return base64(value);
    out.body = jsonText(tree, value);
    return {};
  }

  Status id(const Node& value) {
    const bool plain = value.type != JsonTree::Type::array && value.type != JsonTree::Type::object;
    if (!plain || value.length > 256) return pathError("id", "expected a number or a short string");
    out.id = jsonText(tree, value);
    return {};
  }

  Status text(const Node& value, const char* where, std::string& into) {
    OBBY_ASSIGN(into, jsonString(tree, value, where));
    return {};
  }

  Status base64(const Node& value) {
    std::string coded;
    OBBY_RETURN_IF_ERROR(text(value, "base64", coded));
    auto bytes = io::decodeBase64(coded);
    if (!bytes) return pathError("base64", "expected base64");
    out.body = *std::move(bytes);
    return {};
  }
};

}  // namespace

StdioRequest parseStdioRequest(std::string_view line) {
  StdioRequest out;
  const auto tree = JsonTree::parse(line);
  if (!tree) {
    out.call = refuse(400, tree.error());
    return out;
  }
  LineReader reader{*tree, out, {}, {}};
  const Status read = forMembers(
      *tree, tree->root(), "",
      [&](std::string_view name, const Node& value) { return reader.member(name, value); });
  if (!read) {
    out.call = refuse(400, read.error());
    return out;
  }
  out.call = route(reader.method, reader.path);
  if (Call* call = std::get_if<Call>(&out.call)) {
    call->client = 0;
    call->wait = 0;  // events are sent without polling
  }
  return out;
}

std::string stdioReply(const std::string& id, const Reply& reply) {
  io::JsonWriter out;
  out.open('{').key("id").raw(id).field("status", reply.status);
  if (reply.type == "application/json") {
    out.key("body").raw(reply.body);
  } else {
    out.field("text", reply.body);
  }
  return out.finish();
}

}  // namespace obby::bridge
