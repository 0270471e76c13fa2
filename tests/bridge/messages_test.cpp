// The ring of messages, and records cut into messages.
#include <gtest/gtest.h>

#include "bridge/client.h"
#include "bridge/json.h"
#include "bridge/messages.h"
#include "io/json_tree.h"
#include "io/text.h"
#include "io/utf8.h"

namespace obby::bridge {
namespace {

TEST(Ring, numbers_from_one_and_continues_from_any_cursor) {
  Ring ring(1000);
  EXPECT_EQ(ring.last(), 0u);
  EXPECT_TRUE(ring.reaches(0));
  EXPECT_EQ(ring.after(0), nullptr);
  ring.push(1, "{\"a\":1}");
  ring.push(2, "{\"a\":2}");
  EXPECT_EQ(ring.last(), 2u);
  EXPECT_EQ(ring.after(0)->text, "{\"number\":1,\"a\":1}");
  EXPECT_EQ(ring.after(1)->text, "{\"number\":2,\"a\":2}");
  EXPECT_EQ(ring.after(1)->job, 2u);
  EXPECT_EQ(ring.after(2), nullptr);
  EXPECT_EQ(ring.after(99), nullptr);
}

TEST(Ring, forgets_the_oldest_and_reports_it) {
  Ring ring(1000);
  const std::string message = "{\"a\":\"" + std::string(80, 'x') + "\"}";
  for (int i = 0; i < 50; i++) {
    ring.push(1, message);
    EXPECT_LE(ring.bytes(), 1000u);
  }
  EXPECT_EQ(ring.last(), 50u);
  EXPECT_FALSE(ring.reaches(0));
  uint64_t oldest = 0;
  while (!ring.reaches(oldest)) oldest++;
  EXPECT_GT(oldest, 35u);
  EXPECT_EQ(ring.after(oldest)->number, oldest + 1);
  for (uint64_t c = oldest; c < 50; c++) EXPECT_EQ(ring.after(c)->number, c + 1);
}

TEST(Ring, keeps_the_newest_of_any_length) {
  Ring ring(100);
  ring.push(1, "{\"a\":1}");
  ring.push(1, "{\"a\":\"" + std::string(1000, 'x') + "\"}");
  EXPECT_TRUE(ring.reaches(1));
  EXPECT_EQ(ring.after(1)->number, 2u);
}

// While a WebSocket is slower than the program, the ring holds messages for it.
TEST(Ring, held_messages_stay_within_a_bound_until_taken) {
  Ring ring(1000, 3000);
  const std::string message = "{\"a\":\"" + std::string(80, 'x') + "\"}";
  ring.hold(0);
  for (int i = 0; i < 25; i++) ring.push(1, message);
  EXPECT_GT(ring.bytes(), 2000u);
  EXPECT_TRUE(ring.reaches(0));
  ring.hold(20);
  EXPECT_LE(ring.bytes(), 1000u);
  EXPECT_TRUE(ring.reaches(20));
  for (int i = 0; i < 50; i++) {
    ring.push(1, message);
    EXPECT_LE(ring.bytes(), 3000u);
  }
  EXPECT_FALSE(ring.reaches(20));
  ring.release();
  EXPECT_LE(ring.bytes(), 1000u);
  EXPECT_EQ(ring.after(74)->number, 75u);
}

// The client asks its carrier to take all messages, so none is lost, however many arrive at once.
TEST(Client, asks_its_carrier_before_messages_are_lost) {
  Client client(1, 1000);
  uint64_t had = 0;
  client.beforeLoss = [&] {
    ASSERT_TRUE(client.ring().reaches(had));
    while (const Message* message = client.ring().after(had)) had = message->number;
  };
  const std::string message = "{\"a\":\"" + std::string(80, 'x') + "\"}";
  for (int i = 0; i < 50; i++) {
    client.tell(1, message);
    EXPECT_TRUE(client.ring().reaches(had));
  }
  EXPECT_GT(had, 40u);
}

// Returns the text of the messages, joined as a client would join it.
std::string joined(const std::vector<std::string>& messages) {
  std::string out;
  for (size_t i = 0; i < messages.size(); i++) {
    const auto tree = io::JsonTree::parse(messages[i]);
    EXPECT_TRUE(tree);
    if (!tree) return {};
    uint64_t index = 0, count = 0;
    const Status read =
        forMembers(*tree, tree->root(), "", [&](std::string_view name, const auto& value) {
          if (name == "index") index = value.value;
          if (name == "count") count = value.value;
          if (name == "text") out += tree->text(value);
          return Status();
        });
    EXPECT_TRUE(read);
    EXPECT_EQ(index, i);
    EXPECT_EQ(count, messages.size());
  }
  return out;
}

TEST(Fragments, short_records_stay_whole) {
  const auto messages = recordMessages("j1", "{\"type\":\"end\"}", 1024);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0], "{\"job\":\"j1\",\"type\":\"record\",\"record\":{\"type\":\"end\"}}");
}

TEST(Fragments, long_records_are_restored_from_their_pieces) {
  std::string record = "{\"type\":\"metrics\",\"name\":\"";
  for (int i = 0; i < 3000; i++)
    record += i % 3 == 0 ? "\\\"" : i % 3 == 1 ? "\xf0\x9f\x98\x80" : "a";
  record += "\"}";
  for (const uint64_t limit : {1024u, 1025u, 1026u, 1027u, 4096u}) {
    const auto messages = recordMessages("j123456789012345", record, limit);
    EXPECT_GT(messages.size(), 1u);
    for (const std::string& message : messages) {
      EXPECT_LE(message.size(), limit);
      EXPECT_TRUE(io::isUtf8(message));
    }
    EXPECT_EQ(joined(messages), record);
  }
}

TEST(Json, invalid_utf8_is_replaced) {
  EXPECT_EQ(io::validUtf8("a\xff\xc3z"), "a\xef\xbf\xbd\xef\xbf\xbdz");
}

TEST(Json, trees_convert_back_to_text) {
  const std::string text = "{\"a\":[1,-2,0.1,1e300,\"x\\n\\\"\",null,true,false,{},[]]}";
  const auto tree = io::JsonTree::parse(text);
  ASSERT_TRUE(tree);
  EXPECT_EQ(jsonText(*tree, tree->root()), text);
}

}  // namespace
}  // namespace obby::bridge
