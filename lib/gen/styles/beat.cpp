// Platforms that appear and disappear to a beat, alternately.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"platforms", "", 2, 5, 1, 12, "number of platforms"},
    {"beat", "seconds", 2.5f, 1.25f, 0.5f, 10,
     "time that a platform stays, and then the time until it returns"},
    {"size", "studs", 7, 4.5f, 2, 20, "size of a platform"},
};
const auto& [kPlatforms, kPeriod, kSize] = kParameters;

void build(Sketch& s) {
  const uint32_t platforms = s.mixCount(kPlatforms);
  const float beat = s.mix(kPeriod);
  for (uint32_t i = 0; i < platforms; ++i) {
    const float size = s.mix(kSize), phase = i % 2 == 0 ? 0 : beat;
    s.floor("Beat block", size, size, s.gap(0, 0.6f))
        .colored(colors::kBeat[i % 2])
        .vanishing({schema::VanishTrigger::TIMER, beat, beat, phase, false});
    s.expectWait(2 * beat);
  }
}

}  // namespace

constinit const Style kBeatStyle{.name = "beat",
                                 .description = "platforms that come and go to a beat",
                                 .build = build,
                                 .parameters = kParameters};

}  // namespace obby::gen
