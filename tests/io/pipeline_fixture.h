// A pipeline that reads texts, writes to a string, and collects its reports.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/pipeline.h"
#include "io/version.h"
#include "scratch_folder.h"

namespace obby::test {

struct PipelineFixture {
  ScratchFolder folder;
  std::string output;
  std::vector<std::string> reports, places;
  io::SourceOptions options;

  PipelineFixture() {
    options.inputs.clear();
    options.report = [this](const Error& error) {
      reports.push_back(error.message);
      places.push_back(error.input + ":" + error.place);
    };
  }
  void input(const std::string& text) {
    const std::string path = folder / std::to_string(options.inputs.size());
    std::ofstream(path) << text;
    options.inputs.push_back(path);
  }
  io::Pipeline pipeline(io::Format format = io::Format::jsonl) {
    return io::Pipeline(options, {"obby-test", "1.2.3", 42},
                        io::StreamWriter::toBytes(format, &output));
  }
  // Returns the output's end record in JSON.
  std::string end() const {
    io::StreamReader reader = io::StreamReader::overBytes(output, "output");
    std::string line;
    for (auto record = reader.next(); record && *record; record = reader.next()) {
      if (!(*record)->known() || (*record)->which() != io::Kind::END) continue;
      io::StreamWriter writer = io::StreamWriter::toBytes(io::Format::jsonl, &line);
      EXPECT_TRUE(writer.write((*record)->reader()));
    }
    return line;
  }
};

inline const std::string kHeader =
    "{\"type\":\"header\",\"schemaMajor\":" + std::to_string(io::kSchemaMajor) +
    ",\"schemaMinor\":" + std::to_string(io::kSchemaMinor) +
    ",\"tool\":\"obby-test\",\"version\":"
    "\"1.2.3\",\"seed\":\"42\","
    "\"floatPolicy\":\"ieee754-nofma\"}\n";

inline Result<io::Then> passAll(const io::Record&) { return io::Then::pass; }

}  // namespace obby::test
