// Committed state hashes. Every compiler, optimisation level, instruction set, thread count and
// machine must produce these bits (docs/determinism.md). A deliberate change of physics changes
// them. Then the change log says *hash*, and the output of the failing test replaces the table.
#pragma once

#include <cstdint>

#include "golden/dynamic_scenes.h"

namespace obby::golden {

struct Scene {
  const char* name;
  LevelBuilder (*build)();
  uint64_t hash;
};

inline const Scene kScenes[] = {
    {"arena20", [] { return support::boxArena(20, 1); }, 0x81aa4aeb076b106a},
    {"arena100", [] { return support::boxArena(100, 2); }, 0xf84f11e6fbb3dc5a},
    {"arena300", [] { return support::boxArena(300, 3); }, 0x90d100511d01f988},
    {"course", [] { return support::platformCourse(40, 4); }, 0xa21790bd8cd9f4d1},
    {"shapes", shapes, 0xf6115841707b55b6},
    {"carriers", [] { return movers(true); }, 0xa03cf3ec50b7af90},
    {"scripted movers", [] { return movers(false); }, 0x785852935e0e2ffa},
    {"roles", roles, 0xbfb412bb1e01c39a},
    {"trusses", trusses, 0xad71f5e3257d70e6},
    {"low gravity, fast walk",
     [] {
       return support::platformCourse(40, 6).physics([](auto p) {
         p.setGravity(80);
         p.setWalkSpeed(54);
       });
     },
     0x3549c9ac9cfea33d},
    {"30 Hz control, 8 substeps",
     [] {
       return support::boxArena(60, 7).physics([](auto p) {
         p.setControlRate(30);
         p.setSubsteps(8);
       });
     },
     0x6e16839e9a69fdcb},
    {"balls", [] { return scatteredOf(schema::Shape::BALL); }, 0x683bc6a507021099},
    {"cylinders", [] { return scatteredOf(schema::Shape::CYLINDER); }, 0xe48f51d15291da12},
    {"wedges", [] { return scatteredOf(schema::Shape::WEDGE); }, 0xc68623e267624249},
    {"corner wedges", [] { return scatteredOf(schema::Shape::CORNER_WEDGE); }, 0xa92ef08b5dcd2ad4},
    {"hulls", hulls, 0x970697e8745d10f1},
    {"spinners", spinners, 0x6fd592323c5b112a},
    {"extremes", extremes, 0xd6f4ffddf670bc7d},
    {"stairs", stairs, 0x3cd90690456dbe60},
    {"slopes", slopes, 0x3ef41f76ea6b74fe},
    {"pads", pads, 0xbce077574b9c9ccd},
    {"vanishing", vanishing, 0x37cae8c3c073dd22},
    {"killers", killers, 0x4fb2eb74db253b78},
    {"weights", weights, 0x44a1b34ce02f2be3},
    {"jumps in the air", airJumps, 0x4d4cf09ce7c4ed29},
    {"moving arena", [] { return support::movingArena(40, 12, 8); }, 0x21d10a1298348351},
    {"moving arena, 120 Hz",
     [] {
       return support::movingArena(40, 12, 9).physics([](auto p) {
         p.setControlRate(120);
         p.setSubsteps(2);
       });
     },
     0x3e66eb53b340801f},
    {"clocks", clocks, 0xf8b1f8d913ecce35},
    {"places", places, 0x456ea473f1726e0f},
    {"loose bodies", dynamicBodies, 0x472e6694ecc46845},
    {"loose stack on a carrying platform", dynamicStack, 0xefd83d710b7a2049},
    {"loose arena", [] { return support::bodyArena(16, false, 3); }, 0xdb6b78b526859c7c},
    {"loose seats", dynamicSeats, 0x1655dba95f530d3f},
};

// Each scene runs this many worlds for this many ticks. Walkers with this seed play.
constexpr uint32_t kWorlds = 64, kTicks = 600;
constexpr uint64_t kSeed = 11;

}  // namespace obby::golden
