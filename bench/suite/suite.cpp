#include "suite/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "base/hash.h"
#include "import/filter.h"
#include "level/level.h"
#include "level/resolve_places.h"
#include "suite/effort.h"

namespace obby::bench {
namespace {

struct Row {
  std::string file, id, expected;
  std::string name() const { return file + ":" + id; }
};

Result<std::vector<Row>> readTable(const std::string& path) {
  std::ifstream file(path);
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    Row row;
    std::getline(fields, row.file, '\t');
    std::getline(fields, row.id, '\t');
    std::getline(fields, row.expected, '\t');
    if (row.expected.empty()) return makeError(path + ": a row needs file, query and verdict");
    rows.push_back(row);
  }
  if (rows.empty()) return makeError("cannot read " + path, "name the folder with --levels");
  return rows;
}

Status keepOnly(std::vector<Row>& rows, const std::vector<std::string>& only) {
  std::vector<Row> kept;
  for (const std::string& name : only) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.name() == name; });
    if (found == rows.end()) return makeError("no query " + name, "see --list");
    kept.push_back(*found);
  }
  if (!only.empty()) rows = std::move(kept);
  return {};
}

// The queries of a level file by id, each with the level before it.
struct FileContent {
  struct Asked {
    io::Record level;
    uint64_t levelHash;  // hash of all that can change a trajectory
    io::Record query;
  };
  std::map<std::string, Asked> queries;
};

Result<FileContent> readFile(const std::string& path) {
  importer::InputOpener opener(
      {}, [](const std::string&) {}, [](const std::string&) {});
  OBBY_ASSIGN(io::StreamReader reader, opener.open(path));
  FileContent content;
  std::optional<io::Record> level;
  uint64_t levelHash = 0;
  while (true) {
    OBBY_ASSIGN(const std::optional<io::Record> record, reader.next());
    if (!record) return content;
    if (record->which() == io::Kind::LEVEL) {
      level = *record;
      OBBY_ASSIGN(const level::Level compiled, level::Level::compile(level->reader().getLevel()));
      levelHash = compiled.hash();
    }
    if (record->which() != io::Kind::QUERY || !level) continue;
    io::RecordBuilder query(record->reader());
    OBBY_RETURN_IF_ERROR(level::resolvePlaces(level->reader().getLevel(), query.root().getQuery()));
    const std::string id = record->reader().getQuery().getId();
    content.queries.insert_or_assign(
        id, FileContent::Asked{*level, levelHash, io::Record(std::move(query))});
  }
}

// Digests the query and all that can change a trajectory. The path of a place file and the
// importer's texts are excluded.
Result<uint64_t> digest(const FileContent::Asked& asked) {
  std::string bytes;
  auto writer = io::StreamWriter::toBytes(io::Format::jsonl, &bytes);
  OBBY_RETURN_IF_ERROR(writer.write(asked.query.reader()));
  OBBY_RETURN_IF_ERROR(writer.close());
  return hashBytes(bytes.data(), bytes.size(), asked.levelHash);
}

Result<SuiteQuery> suiteQuery(const Row& row, const FileContent::Asked& asked) {
  OBBY_ASSIGN(const uint64_t content, digest(asked));
  OBBY_ASSIGN(const double effort,
              effortOf(asked.level.reader().getLevel(), asked.query.reader().getQuery()));
  return SuiteQuery{row.file, row.id, row.expected, asked.level, asked.query, content, effort};
}

}  // namespace

Result<std::vector<SuiteQuery>> loadSuite(const std::string& levels,
                                          const std::vector<std::string>& only) {
  OBBY_ASSIGN(std::vector<Row> rows, readTable(levels + "/expected.tsv"));
  OBBY_RETURN_IF_ERROR(keepOnly(rows, only));
  std::map<std::string, FileContent> files;
  std::vector<SuiteQuery> suite;
  for (const Row& row : rows) {
    if (!files.count(row.file)) {
      OBBY_ASSIGN(FileContent content, readFile(levels + "/" + row.file));
      files.emplace(row.file, std::move(content));
    }
    const auto& queries = files.at(row.file).queries;
    const auto found = queries.find(row.id);
    if (found == queries.end()) return makeError(row.name() + ": the level has no such query");
    OBBY_ASSIGN(SuiteQuery query, suiteQuery(row, found->second));
    suite.push_back(std::move(query));
  }
  return suite;
}

}  // namespace obby::bench
