// A log that players walk along, with spikes that turn around it.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"length", "studs", 16, 34, 8, 100, "length of the log"},
    {"diameter", "studs", 8, 5, 3, 20, "diameter of the log"},
    {"spikes", "", 2, 8, 1, 12, "number of spikes along the log"},
    {"speed", "rad/s", 0.5f, 2, 0.5f, 6, "speed of the spikes, in either direction"},
    {"height", "studs", 2, 4, 1, 6, "height of a spike"},
};
const auto& [kLength, kDiameter, kSpikes, kSpeed, kHeight] = kParameters;

void build(Sketch& s) {
  constexpr float kOffRound = 4;  // studs/s that a player gains on the log's flanks
  const float long_ = s.mix(kLength), across = s.mix(kDiameter), gap = s.gap(0, 0.4f);
  s.part("Log", {0, -across / 2, gap + long_ / 2}, {long_, across, across})
      .shaped(schema::Shape::CYLINDER)
      .turned(kAlong)
      .colored(colors::kWood);
  const uint32_t spikes = s.mixCount(kSpikes);
  const float speed = s.mixSpin(kSpeed), step = (long_ - 4) / float(spikes);
  for (uint32_t i = 0; i < spikes; ++i) {
    // The spike stands on top of the log and turns about the log's axis, ahead of the previous
    // spike.
    const float high = s.mix(kHeight), arm = across / 2 + high / 2;
    MotionSketch m;
    m.spin = speed;
    m.spinAxis = {0, 0, 1};
    m.spinPivot = {0, -arm, 0};
    s.noteCarrier(kOffRound + 2 * absf(speed) * arm);
    m.offset = float(i) * 1.1f + 2 * s.unit();
    Sketch::deadly(s.part("Spike", {0, high / 2, gap + 4 + step * float(i)}, {1, high, 1}))
        .moving(m);
  }
  s.advance(gap + long_);
  s.expectWait(float(spikes) * 3);
}

}  // namespace

constinit const Style kLogRollStyle{.name = "log-roll",
                                    .description = "a log with spikes that turn around it",
                                    .build = build,
                                    .parameters = kParameters};

}  // namespace obby::gen
