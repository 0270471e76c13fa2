// Measures how fast one core generates levels. Level and query are built and encoded as Cap'n Proto
// bytes, for each style and for all styles. They are also built without encoding, as in obby-train.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "common/report.h"
#include "gen/generator.h"
#include "gen/styles.h"
#include "io/stream.h"

namespace {

using namespace obby;

constexpr uint64_t kLevels = 2000;
constexpr uint64_t kLevelWords = 4096;

gen::Generator generatorOf(const char* style) {
  gen::Recipe recipe;
  if (style != nullptr) recipe.styles = {{style, 1}};
  auto made = gen::Generator::make(recipe, false);
  if (!made) {
    std::fprintf(stderr, "%s\n", made.error().text().c_str());
    std::exit(1);
  }
  return *std::move(made);
}

struct Records {
  io::RecordBuilder level{kLevelWords}, query;
};

Records make(const gen::Generator& generator, uint64_t index) {
  Records made;
  const gen::Generated from = generator.generate(1, index);
  generator.writeLevel(from, made.level.root().initLevel());
  gen::Generator::writeQuery(from, made.query.root().initQuery());
  return made;
}

double encodedPerSecond(const gen::Generator& generator) {
  std::string bytes;
  return double(kLevels) / bench::cpuSecondsOf([&] {
           auto writer = io::StreamWriter::toBytes(io::Format::capnp, &bytes);
           for (uint64_t i = 0; i < kLevels; ++i) {
             const Records made = make(generator, i);
             if (!writer.write(made.level.reader()) || !writer.write(made.query.reader())) {
               std::exit(1);
             }
           }
         });
}

double builtPerSecond(const gen::Generator& generator) {
  uint64_t parts = 0;
  const double seconds = bench::cpuSecondsOf([&] {
    for (uint64_t i = 0; i < kLevels; ++i) {
      parts += make(generator, i).level.reader().getLevel().getParts().size();
    }
  });
  return parts > 0 ? double(kLevels) / seconds : 0;
}

}  // namespace

int main(int argc, char** argv) {
  bench::Report report(argc, argv, "gen");
  for (const gen::Style& style : gen::styles()) {
    report.add(style.name, "levelsPerSecond", encodedPerSecond(generatorOf(style.name)), "1/s");
  }
  const gen::Generator all = generatorOf(nullptr);
  report.add("all", "levelsPerSecond", encodedPerSecond(all), "1/s");
  report.add("all", "recordsBuiltPerSecond", builtPerSecond(all), "1/s");
}
