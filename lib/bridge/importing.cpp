#include "bridge/importing.h"

#include <fmt/format.h>
#include <signal.h>

#include "bridge/json.h"
#include "bridge/store.h"
#include "io/json_codec.h"
#include "io/json_tree.h"
#include "io/utf8.h"

namespace obby::bridge {
namespace {

constexpr size_t kMaxWarnings = 100;

// Collects the output of obby-import while it runs.
struct Collector {
  Imported out;
  std::optional<Error> error;
  std::unique_ptr<Run> run;

  // obby-import passes records through as they were written. They are stored as lib/io writes them,
  // which is the form that the rest of the bridge reads.
  void onRecord(std::string_view line) {
    if (!typeOfLine(line).empty()) return keep(line);
    const auto record = io::recordFromJsonIfKnown(line);
    if (!record || !*record) return;  // a kind that this version does not know
    if (const auto normal = io::recordToJson((*record)->reader())) keep(*normal);
  }

  void keep(std::string_view line) {
    const std::string_view type = typeOfLine(line);
    if (type != "level" && type != "query") return;
    if (type == "level") out.levels++;
    if (type == "query") out.queries.push_back(queryIdOfLine(line));
    out.lines.append(line).append("\n");
  }

  // Handles `{"type":"error","tool":...,"place":"1","path":...,"message":...}` (--json-errors).
  void onReport(std::string_view line) {
    const auto tree = io::JsonTree::parse(line);
    if (!tree) {
      error = makeError(io::validUtf8(line.substr(0, 1000)));
      return;
    }
    if (out.warnings.size() < kMaxWarnings) out.warnings.emplace_back(line);
    if (typeOfLine(line) != "error") return;
    Error found;
    for (const auto& member : tree->children(tree->root())) {
      if (member.type != io::JsonTree::Type::text) continue;
      const std::string_view name = tree->name(member);
      if (name == "place") found.place = tree->text(member);
      if (name == "path") found.path = tree->text(member);
      if (name == "message") found.message = tree->text(member);
      if (name == "hint") found.hint = tree->text(member);
    }
    error = found;
  }

  Imported finish(const Exit& how) {
    if (how.signal == SIGXCPU) {
      out.refusal = refuse(504, "obby-import exceeded its CPU time limit",
                           "start obby-bridge with a larger --cpu-time");
    } else if (how.signal != 0 || (how.code != 0 && !error)) {
      out.refusal =
          refuse(422,
                 how.signal != 0 ? fmt::format("obby-import was killed by signal {}", how.signal)
                                 : fmt::format("obby-import ended with exit code {}", how.code),
                 "check the file, or start obby-bridge with a larger --memory");
    } else if (how.code != 0) {
      out.refusal = refuse(422, *error);
    } else if (out.levels == 0) {
      out.refusal = refuse(422, "the body has no level", "send a place or level records");
    }
    return std::move(out);
  }
};

}  // namespace

kj::Promise<Imported> importLevel(Loop& loop, const std::string& program, std::string bytes,
                                  const Limits& limits) {
  auto collector = std::make_shared<Collector>();
  auto process =
      Process::start({program, {"--json-errors", "-"}, limits.memoryBytes, limits.cpuSeconds});
  if (!process) {
    collector->out.refusal = refuse(500, process.error());
    return std::move(collector->out);
  }
  Collector* c = collector.get();
  collector->run = std::make_unique<Run>(
      loop, *std::move(process), std::move(bytes), [c](std::string_view l) { c->onRecord(l); },
      [c](std::string_view l) { c->onReport(l); });
  const uint64_t milliseconds = uint64_t(limits.importSeconds * 1000);
  auto late = loop.timer.afterDelay(milliseconds * kj::MILLISECONDS).then([c] {
    c->out.refusal = refuse(504, "obby-import took too long", "send a smaller place");
    return std::move(c->out);
  });
  return c->run->done()
      .then([c](Exit how) { return c->finish(how); },
            [c](kj::Exception&& e) {  // memory ran out
              c->out.refusal = refuse(
                  500, "the level could not be read: " + io::validUtf8(e.getDescription().cStr()),
                  "send a smaller place");
              return std::move(c->out);
            })
      .exclusiveJoin(kj::mv(late))
      .then([collector](Imported result) {
        collector->run = nullptr;
        return result;
      });
}

}  // namespace obby::bridge
