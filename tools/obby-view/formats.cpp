#include "formats.h"

#include <algorithm>
#include <sstream>

#include "base/listed.h"
#include "base/spelling.h"
#include "io/text.h"
#include "options.h"
#include "view/page.h"
#include "view/picture/drawing.h"
#include "view/picture/picture.h"
#include "view/picture/png.h"
#include "view/trajectories_model.h"

namespace obby {
namespace {

Result<std::string> page(const view::Report& report, const cli::Context& context) {
  const io::StreamIdentity self = context.identity();
  return htmlPage(report, {context.arguments().flag("full"), self.tool + " " + self.version});
}

Result<std::string> text(const view::Report& report, const cli::Context& context) {
  return textReport(report, textOptions(context));
}

// The subject of a picture: the first query whose level is known, or the first level without
// queries.
struct Subject {
  const view::LevelEntry* level;
  const view::QueryEntry* query;
};

Result<Subject> subjectOf(const view::Report& report) {
  for (const view::QueryEntry& query : report.queries) {
    if (query.level >= 0) return Subject{&report.levels[size_t(query.level)], &query};
  }
  if (report.levels.empty() || !report.queries.empty())
    return makeError("the input has no level to draw", "put the level before its answers");
  return Subject{&report.levels[0], nullptr};
}

Result<std::string> png(const view::Report& report, const cli::Context& context) {
  OBBY_ASSIGN(const view::PictureOptions options, pictureOptions(context.arguments()));
  OBBY_ASSIGN(const Subject subject, subjectOf(report));
  return pngOf(pictureOf(*subject.level, subject.query, options));
}

Result<std::string> svg(const view::Report& report, const cli::Context& context) {
  OBBY_ASSIGN(const view::PictureOptions options, pictureOptions(context.arguments()));
  OBBY_ASSIGN(const Subject subject, subjectOf(report));
  const std::string& from = context.arguments().text("from");
  const view::Side side = from == "side"    ? view::Side::lateral
                          : from == "above" ? view::Side::above
                                            : view::Side::best;
  return drawingOf(*subject.level, subject.query, {side, options.attempts, options.width});
}

Result<std::string> rbxmx(const view::Report& report, const cli::Context&) {
  const bool any = std::any_of(report.queries.begin(), report.queries.end(),
                               [](const view::QueryEntry& q) { return !q.paths.empty(); });
  if (!any)
    return makeError("the input has no trajectory to write",
                     "solve a query first, with obby-solve");
  return trajectoriesModel(report);
}

constexpr ViewFormat kFormats[] = {
    {"html", ".html .htm ", false, true, page}, {"text", ".txt ", false, false, text},
    {"png", ".png ", true, false, png},         {"svg", ".svg ", false, false, svg},
    {"rbxmx", ".rbxmx ", false, false, rbxmx},
};

// Returns the ending in lower case with its dot, or an empty text.
std::string endingOf(const std::string& path) {
  const size_t name = path.find_last_of('/') + 1;  // 0 without a slash
  const size_t dot = path.find_last_of('.');
  if (dot == std::string::npos || dot <= name || dot + 1 == path.size()) return {};
  return lower(path.substr(dot));
}

bool endsIn(const std::string& path, const std::string& endings) {
  const std::string ending = endingOf(path);
  return !ending.empty() && endings.find(ending + " ") != std::string::npos;
}

// Returns the endings of all formats, such as ".html .htm .txt ".
std::string allEndings() {
  std::string all;
  for (const ViewFormat& format : kFormats) all += format.endings;
  return all;
}

// Formats endings as ".html, .htm, .txt or .svg".
std::string endingsText(const std::string& endings) {
  std::vector<std::string> words;
  std::istringstream in(endings);
  for (std::string word; in >> word;) words.push_back(word);
  return listed(words, "or");
}

}  // namespace

std::span<const ViewFormat> viewFormats() { return kFormats; }

const ViewFormat& wantedFormat(const cli::Arguments& arguments) {
  const bool asked = arguments.has("format");
  const std::string& path = arguments.text("output");
  for (const ViewFormat& format : kFormats) {
    if (asked ? arguments.text("format") == format.name : endsIn(path, format.endings))
      return format;
  }
  return kFormats[1];
}

Status checkEnding(const cli::Arguments& arguments) {
  const std::string& path = arguments.text("output");
  const std::string ending = endingOf(path), known = allEndings();
  if (arguments.has("format") || ending.empty() || endsIn(path, known)) return {};
  return Error{{},
               {},
               "--output",
               "no format has the extension " + io::quoted(ending),
               "use " + endingsText(known) + ", or choose with --format"};
}

}  // namespace obby
