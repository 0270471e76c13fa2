// A level copied in one piece works without the original.
#include "base/flatten.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "golden/scenes.h"

namespace obby::level {
namespace {

struct Copy {
  LevelView view;
  std::unique_ptr<std::byte[]> memory;
  const std::byte* begin;
  size_t bytes;

  explicit Copy(const LevelView& level) : view(level) {
    LevelView sized = level;
    bytes = flatten(sized, 0).size();
    memory = std::make_unique<std::byte[]>(bytes + 128);
    const auto start = (reinterpret_cast<uintptr_t>(memory.get()) + 127) / 128 * 128;
    const auto table = flatten(view, start);
    begin = reinterpret_cast<const std::byte*>(start);
    std::memcpy(reinterpret_cast<void*>(start), table.data(), bytes);
  }

  bool holds(const void* p, size_t size) const {
    const auto* b = static_cast<const std::byte*>(p);
    return b >= begin && b + size <= begin + bytes;
  }
};

// Every table of the copy lies in the copy and has the bytes of the original.
struct Compare {
  const Copy& copy;

  template <class T>
  void operator()(const T* now, const T* then, size_t count) const {
    if (count == 0 || then == nullptr) {
      EXPECT_EQ(now, nullptr);
      return;
    }
    EXPECT_TRUE(copy.holds(now, count * sizeof(T)));
    EXPECT_EQ(reinterpret_cast<uintptr_t>(now) % alignof(T), 0u);
  }
};

golden::LevelBuilder everything() {
  golden::LevelBuilder b = golden::movers(true);
  b.part([](golden::Part::Builder p) {
    p.setShape(schema::Shape::HULL);
    support::set(p.initPosition(), {4, 2, 4});
    support::set(p.initSize(), {4, 4, 4});
    auto vertices = p.initHulls(1)[0].initVertices(4);
    const Vec3 corners[4] = {{2, -1, 0}, {-2, -1, 0}, {0, -1, 2}, {0, 2, 0}};
    for (uint32_t k = 0; k < 4; ++k) support::set(vertices[k], corners[k]);
    p.initKill().setDamage(3);
  });
  return b;
}

TEST(Flatten, every_table_lies_in_the_copy) {
  const Level level = everything().compile();
  const LevelView& v = level.view();
  const Copy copy(v);
  const LevelView& c = copy.view;
  const Compare same{copy};
  same(c.colliders, v.colliders, v.colliderCount);
  same(c.bounds, v.bounds, v.colliderCount + 1);
  same(c.roles, v.roles, v.roleCount);
  same(c.movers, v.movers, v.moverCount);
  same(c.grid.lists, v.grid.lists, v.grid.listWords);
  uint32_t hulls = 0;
  for (uint32_t i = 0; i < v.colliderCount; ++i) {
    const geom::Hull *now = c.colliders[i].shape.hull, *then = v.colliders[i].shape.hull;
    same(now, then, 1);
    if (then == nullptr) continue;
    ++hulls;
    same(now->vertices, then->vertices, then->vertexCount);
    same(now->normals, then->normals, then->faceCount);
    same(now->edges, then->edges, then->edgeCount);
  }
  EXPECT_EQ(hulls, 1u);
  ASSERT_GT(v.moverCount, 0u);
  for (uint32_t i = 0; i < v.moverCount; ++i) {
    same(c.movers[i].keys, v.movers[i].keys, v.movers[i].keyCount);
    same(c.movers[i].spins, v.movers[i].spins, v.movers[i].spinCount);
  }
}

TEST(Flatten, a_table_that_is_shared_is_copied_once) {
  const Level level = everything().compile();
  LevelView one = level.view();
  struct Two {
    const LevelView* views;
  } two;
  const LevelView both[2] = {level.view(), level.view()};
  two.views = both;
  Flattener pair(0);
  pair(two.views, 2);
  EXPECT_LT(pair.take().size(), flatten(one, 0).size() + 2 * sizeof(LevelView) + 256);
}

TEST(Flatten, an_empty_table_becomes_null) {
  const uint32_t some = 1;
  const uint32_t* table = &some;
  Flattener flattener(4096);
  flattener(table, 0);
  EXPECT_EQ(table, nullptr);
  EXPECT_TRUE(flattener.take().empty());
}

}  // namespace
}  // namespace obby::level
