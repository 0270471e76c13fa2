// Measures how closely the simulator reproduces the real engine from the inputs of recordings
// (lib/calibrate/fidelity.h). A case is a category of recordings in one file. The recordings are
// not part of the project; without them the bench says so and measures nothing.
//   bench_fidelity [--json] [--from FOLDER] [CASE...]     default: shared/recordings next to the
//   checkout; files are CASE.jsonl.zst. Categories of a trick are played again with that trick.
#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>

#include "base/thread_pool.h"
#include "calibrate/fidelity.h"
#include "calibrate/mass_centre_fit.h"
#include "calibrate/takes.h"
#include "common/need.h"
#include "common/report.h"
#include "io/read_file.h"
#include "io/stream.h"

namespace {

using namespace obby;
namespace fs = std::filesystem;

struct Options {
  fs::path folder = fs::path(OBBY_SOURCE_DIR) / ".." / "shared" / "recordings";
  bench::Report::Form form = bench::Report::Form::table;
  std::vector<std::string> cases;
};

Options optionsOf(int argc, char** argv) {
  Options out;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) {
      out.form = bench::Report::Form::json;
    } else if (std::strcmp(argv[i], "--from") == 0 && i + 1 < argc) {
      out.folder = argv[++i];
    } else if (argv[i][0] == '-') {
      fmt::print(stderr, "usage: bench_fidelity [--json] [--from FOLDER] [CASE...]\n");
      std::exit(2);
    } else {
      out.cases.push_back(argv[i]);
    }
  }
  return out;
}

Result<std::string> unpacked(const fs::path& path) {
  OBBY_ASSIGN(const std::string packed, io::readFile(path.string()));
  std::string out;
  ZSTD_DStream* const stream = ZSTD_createDStream();
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  std::string block(ZSTD_DStreamOutSize(), '\0');
  size_t left = 1;
  while (in.pos < in.size && !ZSTD_isError(left)) {
    ZSTD_outBuffer to{block.data(), block.size(), 0};
    left = ZSTD_decompressStream(stream, &to, &in);
    out.append(block, 0, to.pos);
  }
  ZSTD_freeDStream(stream);
  if (left != 0) return makeError(path.string() + ": not a whole zstd file");
  return out;
}

Result<std::vector<calibrate::Take>> takesIn(const fs::path& path) {
  OBBY_ASSIGN(std::string bytes, unpacked(path));
  io::StreamReader reader = io::StreamReader::overBytes(std::move(bytes), path.string());
  calibrate::Takes takes;
  for (;;) {
    OBBY_ASSIGN(const auto record, reader.next());
    if (!record) return takes.take();
    OBBY_RETURN_IF_ERROR(takes.handle(*record));
  }
}

// A category of recordings.
struct Category {
  std::string name;
  std::vector<calibrate::Take> takes;
};

// Returns all categories of a folder, sorted by name.
std::vector<Category> categoriesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().ends_with(".jsonl.zst")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Category> out;
  for (const fs::path& path : files) {
    const std::string file = path.filename().string();
    out.push_back({file.substr(0, file.find('.')), bench::need(takesIn(path))});
  }
  return out;
}

// Returns the source in a name: "R-026-jump_up-001" is from R-026. Each source has one avatar.
std::string sourceOf(const std::string& recording) {
  return recording.substr(0, recording.find('-', recording.find('-') + 1));
}

using Sources = std::map<std::string, std::vector<const calibrate::Track*>>;

Sources sourcesOf(const std::vector<Category>& all) {
  Sources out;
  for (const Category& category : all) {
    for (const calibrate::Take& take : category.takes)
      out[sourceOf(take.track.name)].push_back(&take.track);
  }
  return out;
}

// Returns the avatar's centre of mass from its other recordings, or the root's centre if not
// requested.
calibrate::MassCentre centreOf(const calibrate::Take& take, const Sources& sources) {
  const auto level = bench::need(level::Level::compile(take.level.reader().getLevel()));
  const auto& tracks = sources.at(sourceOf(take.track.name));
  return calibrate::massCentreOf(tracks, take.track, level.view().params);
}

calibrate::FidelitySummary play(const std::vector<calibrate::Take>& takes, uint16_t tricks,
                                const Sources* sources, ThreadPool& pool) {
  io::RecordBuilder defaults;
  const auto params = defaults.root().initParams().asReader();
  std::vector<calibrate::Fidelity> all(takes.size());
  pool.run(int(takes.size()), [&](int i) {
    const calibrate::Take& take = takes[size_t(i)];
    const auto centre = sources ? centreOf(take, *sources) : calibrate::MassCentre{};
    all[size_t(i)] = bench::need(calibrate::fidelityOf(take, params, tricks, centre));
  });
  return calibrate::summaryOf(all);
}

// Returns the trick of a category, or 0.
uint16_t trickOf(const std::string& category) {
  if (category == "held_jump") return kHeldJump;
  return category == "hang_landing" ? kHangingLanding : 0;
}

void report(bench::Report& to, const std::string& name, size_t count,
            const calibrate::FidelitySummary& s) {
  to.add(name, "recordings", double(count), "");
  to.add(name, "medianMeanStuds", s.medianMean, "studs");
  to.add(name, "p95MeanStuds", s.p95Mean, "studs");
  if (s.matched) to.add(name, "eventsWithinAFrame", *s.matched, "");
  if (s.medianApex) to.add(name, "apexErrorStuds", *s.medianApex, "studs");
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = optionsOf(argc, argv);
  if (!fs::is_directory(options.folder)) {
    fmt::print(stderr, "bench: NOT MEASURED: no recordings of the real engine in {}\n",
               options.folder.lexically_normal().string());
    return 77;
  }
  const std::vector<Category> all = categoriesIn(options.folder);
  const Sources sources = sourcesOf(all);
  bench::Report to("fidelity", options.form);
  ThreadPool pool(availableThreads());
  for (const Category& category : all) {
    const auto& asked = options.cases;
    const auto& [name, takes] = category;
    const bool wanted = asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
    if (takes.empty() || !wanted) continue;
    report(to, name, takes.size(), play(takes, 0, &sources, pool));
    // Assumes that every avatar's centre of mass is at the root's centre.
    to.add(name, "medianMeanOfRootStuds", play(takes, 0, nullptr, pool).medianMean, "studs");
    const uint16_t trick = trickOf(name);
    if (trick == 0) continue;
    report(to, name + "_with_trick", takes.size(), play(takes, trick, &sources, pool));
  }
  return all.empty() ? 1 : 0;
}
