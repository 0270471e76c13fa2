// Committed state hashes: every compiler, optimisation level, instruction set, thread count and
// machine must give these bits (docs/determinism.md). A change of physics moves them on purpose:
// then the change log says *hash*, and the table is replaced by what the failing test prints.
#pragma once

#include <cstdint>

#include "golden/loose_scenes.h"

namespace obby::golden {

struct Scene {
  const char* name;
  LevelBuilder (*build)();
  uint64_t hash;
};

inline const Scene kScenes[] = {
    {"arena20", [] { return support::boxArena(20, 1); }, 0x59f08102ca786f17},
    {"arena100", [] { return support::boxArena(100, 2); }, 0xb48d47b0fab4adfa},
    {"arena300", [] { return support::boxArena(300, 3); }, 0xa591d0de4a77c1fb},
    {"course", [] { return support::platformCourse(40, 4); }, 0x3b8d6399c66034c9},
    {"shapes", shapes, 0xf82fccb00464a993},
    {"carriers", [] { return movers(true); }, 0x0cbd4fee33ebe34d},
    {"scripted movers", [] { return movers(false); }, 0x4149995b3278173b},
    {"roles", roles, 0xfe991d549f41db1b},
    {"trusses", trusses, 0x74aed15e7a3fba4a},
    {"low gravity, fast walk",
     [] {
       return support::platformCourse(40, 6).physics([](auto p) {
         p.setGravity(80);
         p.setWalkSpeed(54);
       });
     },
     0x8c5d0960adc3e448},
    {"30 Hz control, 8 substeps",
     [] {
       return support::boxArena(60, 7).physics([](auto p) {
         p.setControlRate(30);
         p.setSubsteps(8);
       });
     },
     0x80f719c644c5868},
    {"balls", [] { return crowdOf(schema::Shape::BALL); }, 0x6ffbeeae1e196078},
    {"cylinders", [] { return crowdOf(schema::Shape::CYLINDER); }, 0x8186c9db0554ede7},
    {"wedges", [] { return crowdOf(schema::Shape::WEDGE); }, 0x5979a01cf10804e6},
    {"corner wedges", [] { return crowdOf(schema::Shape::CORNER_WEDGE); }, 0x7ce7a44566946cdb},
    {"hulls", hulls, 0x32924da28105269c},
    {"spinners", spinners, 0xae2d35e5d872e84b},
    {"extremes", extremes, 0x1ff27ba8eb7c0b93},
    {"stairs", stairs, 0xb797ad3b66e20dac},
    {"slopes", slopes, 0xadfaa612b58bb749},
    {"pads", pads, 0xaccbd02980951379},
    {"vanishing", vanishing, 0x40593e38b5225205},
    {"killers", killers, 0x88be480d35a3dc39},
    {"moving arena", [] { return support::movingArena(40, 12, 8); }, 0xecb53d6af1a8b828},
    {"moving arena, 120 Hz",
     [] {
       return support::movingArena(40, 12, 9).physics([](auto p) {
         p.setControlRate(120);
         p.setSubsteps(2);
       });
     },
     0x3952a2b4a872f904},
    {"clocks", clocks, 0x0423e370eca0601c},
    {"places", places, 0xd4fa882fb5c88f05},
    {"loose bodies", looseBodies, 0x54fc33b7b329ca5f},
    {"loose stack on a carrying platform", looseStack, 0x36f68e84d21a7319},
    {"loose arena", [] { return support::looseArena(16, false, 3); }, 0x4f27e08c2eb632b},
    {"loose seats", looseSeats, 0x2650937182da4ab6},
};

// What is played in each: so many worlds for so many ticks, by walkers of this seed.
constexpr uint32_t kWorlds = 64, kTicks = 600;
constexpr uint64_t kSeed = 11;

}  // namespace obby::golden
