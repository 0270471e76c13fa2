#include "gen/sketch.h"

#include <cstring>

namespace obby::gen {

namespace {

constexpr float kShareSpread = 0.05f;
constexpr float kThick = 1;     // thickness of floors, studs
constexpr float kHeadroom = 6;  // height of a region above a floor, studs
constexpr float kAskew = 7;     // studs added to an impossible gap on a diagonal route
constexpr uint64_t kExcessStream = 0x9e3779b97f4a7c15u;

// Two floor colors for each theme.
constexpr Color kThemes[][2] = {
    {{196, 199, 206}, {168, 173, 184}}, {{214, 190, 150}, {190, 164, 122}},
    {{160, 190, 140}, {134, 166, 116}}, {{186, 170, 210}, {160, 142, 190}},
    {{230, 170, 160}, {206, 146, 138}}, {{140, 186, 196}, {114, 162, 174}}};
constexpr uint32_t kThemeCount = sizeof(kThemes) / sizeof(kThemes[0]);

}  // namespace

Sketch::Sketch(const Reach& reach, const Recipe& recipe, Random random, SketchPlan plan)
    : Draws(recipe, random), reach_(&reach), excess_(random.next(), kExcessStream), plan_(plan) {
  random_.next();
  parts_.reserve(24);
  theme_ = random_.below(kThemeCount);
  bendSide_ = side();
}

// ------------------------------------------------------------------------------------ measures

float Sketch::beyond() {
  return recipe_->excess.lo + (recipe_->excess.hi - recipe_->excess.lo) * excess_.unit();
}

bool Sketch::broken(const char* what) {
  const bool here = crossings_++ == plan_.planted;
  if (here) plantedWhat_ = std::string(what) + "-" + std::to_string(crossings_);
  return here;
}

float Sketch::gap(float rise, float share) {
  const float max = reach_->gap(rise),
              mine = rounded(max * this->share(kShareSpread) * share, 0.125f);
  ++jumps_;
  if (!broken("gap")) return mine;
  // A proof bounds a rotated part by an axis-aligned box.
  const bool askew = heading_ % 0x4000 != 0;
  const float more = plan_.fastest * reach_->flight() + (askew ? kAskew : 0);
  return rounded(kProof * max + beyond() + more, 0.125f);
}

float Sketch::sideGap(float share) {
  return rounded(reach_->gap(0) * this->share(kShareSpread) * share, 0.125f);
}

float Sketch::roundabout(float min) const {
  const float jump = rounded(kProof * reach_->widest(), 0.5f);
  if (jump <= min) return min;
  float aside = 0;
  for (const PartSketch& p : parts_) {
    const float middle = absf(dot(p.position - edge_, direction({1, 0, 0})));
    aside = maxf(aside, middle + maxf(p.size.x, p.size.z) / 2);
  }
  return aside + jump;
}

float Sketch::easyRise(float share) {
  ++jumps_;
  return rounded(reach_->rise() * this->share(kShareSpread) * share, 0.125f);
}

float Sketch::rise(float share) {
  const float mine = easyRise(share);
  return broken("rise") ? rounded(reach_->rise() + beyond(), 0.125f) : mine;
}

float Sketch::highLedge(const Parameter& beyond) {
  return rounded(reach_->rise(), 0.5f) + mix(beyond);
}

// Turns to another of three headings: ahead, diagonal or sideways. A route never turns back.
void Sketch::bend(float diameter) {
  constexpr uint32_t kHeadings = 3;
  const int16_t step = int16_t(0x2000 * (bendSide_ < 0 ? -1 : 1));
  const uint32_t now = uint32_t(int16_t(heading_) / step);
  const uint32_t next = (now + 1 + below(kHeadings - 1)) % kHeadings;
  turnAbout(diameter, Turns(int16_t(next) * step));
}

// ------------------------------------------------------------------------------------ parts

std::string Sketch::numbered(const char* name) {
  for (Numbered& n : names_) {
    if (std::strcmp(n.name, name) == 0) return std::string(name) + ' ' + std::to_string(++n.used);
  }
  names_.push_back({name, 1});
  return std::string(name) + " 1";
}

std::string Sketch::signal(const char* kind) { return numbered(kind); }

Color Sketch::shade() { return kThemes[theme_][shades_++ % 2]; }

PartSketch& Sketch::part(const char* name, Vec3 from, Vec3 size) {
  PartSketch& p = parts_.emplace_back();
  p.name = numbered(name);
  p.position = at(from);
  p.rotation = facing();
  p.size = size;
  p.color = kThemes[theme_][0];
  return p;
}

PartSketch& Sketch::floor(const char* name, float length, float width, float gap, float up,
                          float right) {
  PartSketch& p = part(name, {right, up - kThick / 2, gap + length / 2}, {width, kThick, length})
                      .colored(shade());
  advance(gap + length, up, right);
  return p;
}

PartSketch& Sketch::disc(const char* name, float diameter, float gap, float up) {
  PartSketch& p = part(name, {0, up - kThick / 2, gap + diameter / 2}, {kThick, diameter, diameter})
                      .shaped(schema::Shape::CYLINDER)
                      .turned(kUpright)
                      .colored(shade());
  advance(gap + diameter, up);
  return p;
}

PartSketch& Sketch::wall(const char* name, float right, float forward, float width, float height,
                         float thickness, float up) {
  constexpr float kFoot = 0.5f;
  return part(name, {right, up + (height - kFoot) / 2, forward}, {width, height + kFoot, thickness})
      .colored(colors::kWall);
}

MotionSketch Sketch::slide(Vec3 from, Vec3 to, float seconds, float offset) {
  MotionSketch m;
  m.keys = {{0, at(from)}, {seconds, at(to)}};
  m.offset = offset;
  waits_ += seconds;
  return m;
}

PartSketch& Sketch::deadly(PartSketch& part) {
  part.kill = true;
  return part.colored(colors::kKill);
}

// ------------------------------------------------------------------------------------ the frame

// Adds a stop in the middle of the floor that ends at the edge.
void Sketch::stop(uint32_t part, float length, Vec3 extents) {
  via({0, 0, -length / 2});
  stops_.push_back({part, line_.back(), extents, heading_});
}

void Sketch::start() {
  constexpr float kSize = 10;
  edge_ = {0, 0, kSize / 2};
  PartSketch& p = floor("Start", kSize, kSize);
  p.name = "Start";
  p.color = colors::kStart;
  stop(0, kSize, {kSize, kHeadroom, kSize});
}

void Sketch::begin(float difficulty) { difficulty_ = clampf(difficulty, 0.0f, 1.0f); }

// Adds the floor after an obstacle. The gap before it can be crossed by walking, so that only the
// obstacle decides the difficulty.
void Sketch::rest(bool last, bool mayTurn) {
  const float near = reach_->walkedGap() * (0.4f + 0.5f * difficulty_);
  const float mine = gap();
  --jumps_;
  const float across = mine > reach_->gap(0) ? mine : rounded(minf(near, mine), 0.125f);
  const bool turns = chance(recipe_->turns) && mayTurn && !last;
  const float size = turns ? 10 : mixed({10, 7});
  PartSketch& p =
      turns ? disc("Checkpoint", size, across) : floor("Checkpoint", size, size, across);
  p.color = last ? colors::kGoal : colors::kCheckpoint;
  p.goal = last;
  if (last) p.name = "Goal";
  if (!last) p.checkpoint = int32_t(stops_.size());
  const float extents = turns ? size * kHalfRoot : size;
  stop(uint32_t(parts_.size()) - 1, size, {extents, kHeadroom, extents});
  if (turns) bend(size);
}

float Sketch::seconds() const {
  return along_ / maxf(reach_->params().walkSpeed, 1.0f) + waits_ + 0.5f * float(jumps_);
}

}  // namespace obby::gen
