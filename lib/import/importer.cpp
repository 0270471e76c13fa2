// Turns the bytes of a place into records.
#include "import/importer.h"

#include <algorithm>

#include "import/format/read_document.h"
#include "import/level/build_level.h"
#include "import/observed/run.h"
#include "import/records/designer_queries.h"
#include "import/records/explain.h"
#include "import/records/level_record.h"
#include "import/records/queries.h"
#include "io/physics.h"

namespace obby::importer {
namespace {

void warn(const LevelDraft& level, const std::vector<io::RecordBuilder>& queries, bool wanted,
          std::vector<std::string>& warnings) {
  if (level.parts.empty()) warnings.push_back(level.file + ": the place has no parts");
  if (level.spawns.empty())
    warnings.push_back(level.file +
                       ": no start found: the place has no SpawnLocation and no part named Start");
  else if (wanted && queries.empty())
    warnings.push_back(level.file + ": no goal or checkpoint found, so no query is written");
  std::string kinds;
  for (const auto& [kind, entry] : level.unmodelled)
    kinds += (kinds.empty() ? "" : ", ") + kind + " (" + std::to_string(entry.count) + ")";
  if (!kinds.empty())
    warnings.push_back(level.file + ": not modelled: " + kinds + "; --explain gives details");
}

}  // namespace

namespace {

// Returns the designer's queries, then one for each stage.
std::vector<io::RecordBuilder> queriesOf(const LevelDraft& level, const Tree& tree, uint16_t rate,
                                         std::vector<std::string>& warnings) {
  std::vector<io::RecordBuilder> queries = designerQueries(level, tree, rate, warnings);
  const size_t own = queries.size();
  for (io::RecordBuilder& stage : stageQueries(level, tree)) {
    const bool taken = std::any_of(
        queries.begin(), queries.begin() + std::ptrdiff_t(own), [&](const io::RecordBuilder& q) {
          return q.reader().getQuery().getId() == stage.reader().getQuery().getId();
        });
    if (!taken) queries.push_back(std::move(stage));
  }
  return queries;
}

}  // namespace

std::string levelName(const std::string& file) {
  if (file == "-" || file.empty() || file == "stdin") return "level";
  std::string stem = file.substr(file.find_last_of('/') + 1);
  const size_t dot = stem.find_last_of('.');
  if (dot != std::string::npos && dot > 0) stem.resize(dot);
  return stem;
}

Import importDocument(const Document& document, const ImportOptions& options) {
  const ObservedPlace place =
      options.runScripts ? observePlace(document) : ObservedPlace{document, {}, false};
  const Tree tree(place.document);
  const LevelDraft level =
      buildLevel(tree, place, options.name.empty() ? levelName(document.file) : options.name);
  Import result;
  for (const std::string& warning : document.warnings)
    result.warnings.push_back(document.file + ": " + warning);
  result.level = levelRecord(level, tree);
  if (const auto found = designerPhysics(tree, result.warnings)) {
    io::Physics physics;
    physics.know(*found);
    physics.apply(result.level.root().getLevel());
  }
  if (options.queries) {
    const uint16_t rate = result.level.reader().getLevel().getPhysics().getControlRate();
    result.queries = queriesOf(level, tree, rate, result.warnings);
  }
  warn(level, result.queries, options.queries, result.warnings);
  if (options.explain) result.explanation = explain(level, tree);
  return result;
}

Result<Import> importPlace(std::string_view bytes, const std::string& file,
                           const ImportOptions& options) {
  OBBY_ASSIGN(const Document document, readDocument(bytes, file));
  return importDocument(document, options);
}

}  // namespace obby::importer
