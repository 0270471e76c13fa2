// Tests input from files and from pipes: single bytes, interrupting signals, and stop requests.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "io/stream.h"
#include "io/version.h"
#include "random_record.h"
#include "scratch_folder.h"

namespace obby::io {
namespace {

using test::ScratchFolder;

std::string stream(Format format) {
  std::string bytes;
  StreamWriter writer = StreamWriter::toBytes(format, &bytes);
  RecordBuilder header, end;
  header.root().initHeader().setSchemaMajor(kSchemaMajor);
  end.root().initEnd();
  EXPECT_TRUE(writer.write(header.reader()));
  for (uint32_t i = 0; i < 4; i++) {
    test::RecordFiller filler(i, 0.5f, 3);
    EXPECT_TRUE(writer.write(filler.fill(Kind::LEVEL).reader()));
  }
  EXPECT_TRUE(writer.write(end.reader()));
  return bytes;
}

uint64_t countRecords(StreamReader& reader) {
  for (uint64_t n = 0;; n++) {
    auto record = reader.next();
    EXPECT_TRUE(record) << record.error().text();
    if (!record || !*record) return n;
  }
}

TEST(Source, FilesAreReadAndMissingOnesNamed) {
  ScratchFolder folder;
  std::ofstream(folder / "a.jsonl") << stream(Format::jsonl);
  auto reader = StreamReader::open(folder / "a.jsonl");
  ASSERT_TRUE(reader);
  EXPECT_EQ(countRecords(*reader), 6u);
  auto missing = StreamReader::open(folder / "b.jsonl");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().text(), folder / "b.jsonl: cannot open: No such file or directory");
  auto directory = StreamReader::open(folder / "");
  ASSERT_FALSE(directory);
  EXPECT_EQ(directory.error().message, "cannot read: Is a directory");
}

void sourceOnSignal(int) {}

// Each byte arrives on its own, and a signal comes between any two bytes.
TEST(Source, PipesMayDeliverSingleBytesAmongSignals) {
  struct sigaction action {};
  action.sa_handler = sourceOnSignal;
  ASSERT_EQ(sigaction(SIGUSR1, &action, nullptr), 0);
  for (Format format : {Format::jsonl, Format::capnp, Format::capnpPacked}) {
    ScratchFolder folder;
    const std::string path = folder / "pipe", bytes = stream(format);
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const pthread_t readerThread = pthread_self();
    std::thread writer([&] {
      const int fd = open(path.c_str(), O_WRONLY);
      for (size_t i = 0; i < bytes.size(); i++) {
        ASSERT_EQ(::write(fd, &bytes[i], 1), 1);
        if (i % 16 == 0) pthread_kill(readerThread, SIGUSR1);
      }
      close(fd);
    });
    const std::atomic<bool> stop{false};
    auto reader = StreamReader::open(path, &stop);
    ASSERT_TRUE(reader);
    EXPECT_EQ(countRecords(*reader), 6u);
    writer.join();
  }
}

TEST(Source, AStopEndsAWaitingRead) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int keptOpen = open(path.c_str(), O_RDWR);
  std::atomic<bool> stop{false};
  auto reader = StreamReader::open(path, &stop);
  ASSERT_TRUE(reader);
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop = true;
  });
  auto record = reader->next();
  stopper.join();
  ASSERT_TRUE(record) << record.error().text();
  EXPECT_FALSE(record->has_value());
  EXPECT_TRUE(reader->stopped());
  close(keptOpen);
}

TEST(Source, ANamedPipeCanWaitForItsWriter) {
  ScratchFolder folder;
  const std::string path = folder / "pipe", bytes = stream(Format::jsonl);
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const std::atomic<bool> stop{false};
  auto reader = StreamReader::open(path, &stop);
  ASSERT_TRUE(reader);
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::ofstream(path) << bytes;
  });
  EXPECT_EQ(countRecords(*reader), 6u);
  writer.join();
}

TEST(Source, AStopEndsTheWaitForAWriter) {
  ScratchFolder folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const std::atomic<bool> stop{true};
  auto reader = StreamReader::open(path, &stop);
  ASSERT_TRUE(reader);
  auto record = reader->next();
  ASSERT_TRUE(record) << record.error().text();
  EXPECT_FALSE(record->has_value());
  EXPECT_TRUE(reader->stopped());
}

TEST(Source, ALineOfManyMegabytesIsRead) {
  const std::string name(40u << 20, 'x');
  StreamReader reader =
      StreamReader::overBytes("{\"type\":\"level\",\"name\":\"" + name + "\"}\n", "in");
  auto record = reader.next();
  ASSERT_TRUE(record && *record);
  EXPECT_EQ((*record)->reader().getLevel().getName().size(), name.size());
}

}  // namespace
}  // namespace obby::io
