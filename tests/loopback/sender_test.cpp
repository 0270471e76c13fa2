// Tests which Host and Origin headers count as this machine.
#include "loopback/sender.h"

#include <gtest/gtest.h>

namespace obby::loopback {
namespace {

TEST(Sender, hosts_are_the_loopback_with_the_port) {
  for (const char* host :
       {"127.0.0.1:34990", "localhost:34990", "LocalHost:34990", "[::1]:34990"}) {
    EXPECT_TRUE(hostAllowed(host, 34990)) << host;
  }
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:34991", "example.org:34990", "0.0.0.0:34990",
                           "127.0.0.1:34990.example.org", " 127.0.0.1:34990", "127.0.0.1:034990"}) {
    EXPECT_FALSE(hostAllowed(host, 34990)) << host;
  }
  EXPECT_TRUE(hostAllowed("localhost", 80));
}

TEST(Sender, origins_of_other_schemes_hosts_and_ports_are_foreign) {
  EXPECT_TRUE(originIsOwn("http://127.0.0.1:8080", 8080));
  EXPECT_TRUE(originIsOwn("HTTP://localhost:8080", 8080));
  for (const char* origin :
       {"", "null", "file://", "http://", "https://127.0.0.1:8080", "http://127.0.0.1:8081",
        "http://127.0.0.1", "http://evil.example:8080", "http://127.0.0.1:8080.evil.example",
        "http://127.0.0.1:8080/", "127.0.0.1:8080", "http://evil@127.0.0.1:8080"}) {
    EXPECT_FALSE(originIsOwn(origin, 8080)) << origin;
  }
}

}  // namespace
}  // namespace obby::loopback
