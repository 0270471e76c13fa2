# The stream schema, which defines every record that the tools read and write.
#
# JSON is derived from this file by reflection (lib/io/json_codec). A record is one object on one line. Its `type` names
# its kind, a field of the union in Record. Its other members are the fields of that kind, spelled as here. JSON omits
# empty lists and texts, and fields at their default unless they are marked $always. Structs marked $tuple are arrays of
# their fields in order. 64-bit integers are decimal strings, and enumerants are names.
#
# Rules for changes: a new field (last, with a default that means "as before"), a new enumerant (last) or a new kind of
# record raises `kSchemaMinor` in lib/io/version.h, and so does a new name for an old one ($formerly). Any other change raises
# `kSchemaMajor`. Both rules apply from the first release on.
#
# Units: lengths are in studs (1 stud = 0.28 m), times in seconds unless the name says ticks, angles in radians unless
# the name says turns. Y is up, axes are right-handed, and a yaw of 0 looks along -Z.
@0xe8b3c0f2a4d15b97;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

annotation tuple @0xc1d7c7c3a3a1f0b1 (struct) :Void;
# In JSON this struct is an array of its fields, in the order of declaration.

annotation always @0x9f4b2c6d81e3a705 (field) :Void;
# JSON has this field even at its default, because scripts look for it.

annotation formerly @0xf3a61d0c97b2e854 (field, enumerant) :Text;
# An earlier name. JSON with this name is read; JSON is written with the present name.

annotation unit @0xb0f5e1a7d9c3a2e4 (field) :Text;
# The unit of a number, also shown in obby-calibrate's reports.

annotation range @0xd2a9f8e3b7c61a55 (field) :Interval;
# Input outside this interval is rejected, and calibration searches inside it.

annotation source @0xa6e4d3c2b1f09876 (field) :Text;
# The source of a number and its reliability: H is official or tested, M credible, L weak.

annotation example @0xb3d58e17c20f6a94 (field) :Text;
# A typical value in JSON. Errors show an object with these fields, or with the struct's first field at its default.

annotation hint @0xde2f70a9164bc835 (struct) :Text;
# The way to write a value, shown in errors about it.

struct Interval {
  min @0 :Float64;
  max @1 :Float64;
}

struct Record {
  union {
    header @0 :Header;
    level @1 :Level;
    query @2 :Query;
    progress @3 :Progress;
    trajectory @4 :Trajectory;
    result @5 :Result;
    recording @6 :Recording;
    params @7 :PhysicsParams;
    metrics @8 :Metrics;
    end @9 :End;
  }
}

# ---------------------------------------------------------------------------------------------- geometry values

struct Vec3 $tuple {
  x @0 :Float32;
  y @1 :Float32;
  z @2 :Float32;
}

struct Quat $tuple $hint("a rotation is a quaternion [x,y,z,w]: [0,0.7071,0,0.7071] turns 90 degrees about Y") {
  # A unit quaternion. Input is normalised; a zero quaternion is an error.
  x @0 :Float32;
  y @1 :Float32;
  z @2 :Float32;
  w @3 :Float32 = 1;
}

struct Color $tuple {
  # sRGB, 0 to 255 each; the default is the engine's "Medium stone grey".
  r @0 :UInt8 = 163;
  g @1 :UInt8 = 162;
  b @2 :UInt8 = 165;
}

struct Region {
  # An oriented box.
  name @0 :Text;
  position @1 :Vec3;        # centre
  rotation @2 :Quat;
  size @3 :Vec3 = (x = 4, y = 4, z = 4);  # full extents, each > 0
  # A query can name a part instead of the box: by name, path or end of a path, GUID, #tag or part:INDEX. In lists, a
  # #tag means every part with that tag. In avoid, a name means every part that it fits. All lists together may have at
  # most 100,000 places. The tools fill in partIndex and the box, which is the space around the part.
  part @4 :Text $example("\"Finish\"");
  touch @5 :Bool;            # if true, only touching the part itself counts
  partIndex @6 :Int32 = -1;  # index into the level's parts
}

enum PlayerState {
  # Humanoid states of the engine.
  running @0;
  jumping @1;
  freefall @2;
  landed @3;
  dead @4;
  climbing @5;
  seated @6;
  fallingDown @7;
}

enum Trick {
  # Moves that the engine allows and designers do not plan with (docs/physics.md, tricks).
  heldJump @0;        # a jump made while turning rises without gravity until no floor is sensed
  hangingLanding @1;  # a key held on landing leaves the player up to 1.1 studs above the floor, where a jump can start
  wallHop @2;         # a turn in the air to any direction at once, so that a foot meets the seam or corner of a wall
  ladderFlick @3;     # a second grip on a truss while still rising from a jump off it
  legThrow @4;        # a throw of the body upward by a floor that suddenly comes under the legs
}

# ---------------------------------------------------------------------------------------------- stream framing

struct Header {
  # The first record of a stream.
  schemaMajor @0 :UInt32 = 1 $always;  # readers reject another major version
  schemaMinor @1 :UInt32 $always;
  tool @2 :Text;               # "obby-solve"
  version @3 :Text;            # "0.1.0"
  seed @4 :UInt64;
  floatPolicy @5 :Text;        # "ieee754-nofma" is the arithmetic that replays exactly
}

enum EndStatus {
  complete @0;
  interrupted @1;  # a signal ended the work
  budget @2;       # a time or step budget ended the work before every query had its verdict
  failed @3;       # an error ended the work
}

struct End {
  # The last record of a stream. A stream without it was cut off.
  status @0 :EndStatus $always;
  records @1 :UInt64 $always;   # records written before this one, header included
  skipped @2 :UInt64;   # input records omitted because of errors
  errors @3 :UInt64;
}

# ---------------------------------------------------------------------------------------------- level

struct Level {
  name @0 :Text;
  source @1 :LevelSource;
  physics @2 :PhysicsParams;   # if absent, the defaults below
  parts @3 :List(Part);
  spawns @4 :List(Spawn);      # stages in order; play starts at the first
  unmodelled @5 :List(Unmodelled);
  bodies @6 :List(Text);       # bodies that the place admits; empty if unknown
}

struct LevelSource {
  file @0 :Text;          # as given on the command line
  format @1 :Text;        # rbxl, rbxlx, rbxm, rbxmx, jsonl
  path @2 :Text;          # path in the place; "Workspace" for a whole place
  partsRead @3 :UInt32;
  partsKept @4 :UInt32;
  partsCulled @5 :UInt32; # parts far from all others or below the fall height, and parts that scripts destroy when play starts
}

enum Bearing {
  # The way in which the game can differ from the level because the import lost something.
  either @0;  # easier or harder for the player
  easier @1;  # easier only, so a solution still holds
  harder @2;  # harder only, so unreachable goals stay unreachable
}

struct Unmodelled {
  # A feature that the importer found and the simulator does not model.
  kind @0 :Text;     # "terrain", "constraint PrismaticConstraint", "script that fails"
  count @1 :UInt32;
  example @2 :Text;  # path of one instance
  note @3 :Text;     # the effect of the loss
  bearing @4 :Bearing;
  anywhere @5 :Bool;  # true if some instances concern no single part; the others are in the parts' `doubts`
}

struct Spawn {
  # A place where a player can start: a spawn or a checkpoint.
  name @0 :Text;
  stage @1 :Int32;        # 0 is the start of play; checkpoints count up from there
  position @2 :Vec3;      # position of the feet
  yaw @3 :Float32;        # radians
  part @4 :Int32 = -1;    # index into parts
}

enum Shape {
  block @0;
  ball @1;
  cylinder @2;      # its axis is local X
  wedge @3;         # vertical face at +Z, slope rising from -Z to +Z
  cornerWedge @4;   # apex at (+X, +Y, -Z)
  truss @5;         # collides as a block and can be climbed
  hull @6;          # convex hulls in `hulls`
}

struct Part {
  name @0 :Text;
  shape @1 :Shape;
  position @2 :Vec3;      # centre of the bounding box
  rotation @3 :Quat;
  size @4 :Vec3 = (x = 4, y = 1, z = 2);  # full extents, each above 0 and at most 2048; simulated as 0.05 or more
  hulls @5 :List(Hull);   # only for shape hull
  solid @6 :Bool = true;  # CanCollide
  touch @7 :Bool = true;  # CanTouch: kill, pad and checkpoint tests include the part
  anchored @8 :Bool = true;  # false for a dynamic body
  friction @9 :Float32 = 0.3;     # 0 to 100
  elasticity @10 :Float32 = 0.5;  # elasticity of a dynamic body's contacts, 0 to 1
  density @11 :Float32 = 0.7;     # density of a dynamic body, 0.0001 to 100
  color @12 :Color;
  transparency @13 :Float32;
  source @14 :PartSource;
  kill @15 :Kill;
  conveyor @16 :Conveyor;
  jumpPad @17 :JumpPad;
  vanish @18 :Vanish;
  checkpoint @19 :Checkpoint;
  goal @20 :Goal;
  motion @21 :Motion;
  evidence @22 :List(Evidence);
  tags @23 :List(Text);
  button @24 :Button;
  fall @25 :Fall;
  teleport @26 :Teleport;
  boost @27 :Boost;
  oneWay @28 :OneWay;
  squeeze @29 :Squeeze;
  seat @30 :Seat;
  trip @31 :Trip;
  climbable @32 :Bool;    # true for a rung of a ladder built from parts, which is climbed like a truss
  material @33 :Text;     # appearance only, by the engine's name ("WoodPlanks"); empty for plastic
  frictionWeight @34 :Float32 = 1;  # weight of `friction` in the mean with that of a player or dynamic body, 0 to 100
  byRoot @35 :Bool;       # if true, touched only while the root's centre is inside, as by scripts that compare positions
  doubts @36 :List(Text);  # kinds of `unmodelled` that concern this part, so the game may treat it differently
}

struct PartSource {
  path @0 :Text;          # "Workspace/Stage 1/Lava", for display, because names may repeat
  indices @1 :List(UInt32);  # sibling indices from the root, unique within the file
  guid @2 :Text;          # UniqueId or GUID attribute, if the file has one
  className @3 :Text;
}

struct Hull {
  # One convex hull in the part's own frame, scaled to the part's size.
  vertices @0 :List(Vec3);   # 4 to 255 vertices, in studs from the part's centre
}

struct Evidence {
  # The reason why the importer gave a part a role.
  role @0 :Text;     # "kill", "conveyor", ...
  reason @1 :Text;   # "tag KillBrick", "script KillScript line 3: Health = 0"
  guessed @2 :Bool;  # true if inferred from a name or a default, not stated by the file
}

struct Kill {
  damage @0 :Float32 = 100;     # health lost per touch; 100 kills a player of full health; negative numbers heal, up to maxHealth
  cooldown @1 :Float32;         # min seconds between two touches that take effect
}

struct Conveyor {
  velocity @0 :Vec3 $example("[8,0,0]");  # studs/s, world frame, given to anything that stands on it
  angular @1 :Vec3;    # rad/s, world frame, about the part's centre, which moves with the part
}

struct JumpPad {
  velocity @0 :Vec3 $example("[0,80,0]");  # studs/s, world frame, given to a player who touches it
  keepSideways @1 :Bool = true;  # if true, only the component along `velocity` is set
}

enum VanishTrigger {
  touch @0;
  timer @1;
  signal @2;
}

struct Vanish {
  trigger @0 :VanishTrigger;
  delay @1 :Float32;        # touch, signal: seconds that it stays solid after the start; timer: seconds solid in each period
  away @2 :Float32 = 3;     # touch, timer: seconds without collision; signal: it has none while the signal lasts
  phase @3 :Float32;        # timer: seconds into the period at tick 0
  signal @4 :Text;          # signal: name given by its buttons
  inverted @5 :Bool;        # if true, the part is solid only when it would otherwise be away
}

struct Button {
  # A touch starts its signal, and parts that name the signal (vanish.signal, motion.signal) respond.
  signal @0 :Text $example("\"door\"");  # any name; buttons with the same name start the same signal
  seconds @1 :Float32 = 5;  # duration of the signal; the same for all buttons of a signal
  forever @2 :Bool;         # if true, the signal lasts until the attempt ends
  restarts @3 :Bool;        # if true, a touch while the signal lasts restarts it
}

struct Fall {
  # After a touch the part waits, falls with anything that stands on it, is away, and comes back.
  delay @0 :Float32 = 0.5;  # seconds at rest after the touch
  seconds @1 :Float32 = 1;  # duration of the fall
  speed @2 :Float32;        # constant, studs/s; 0 for free fall under gravity
  away @3 :Float32 = 3;     # seconds without collision after the fall
  solid @4 :Bool = true;    # if false, it has no collision while falling
}

struct Teleport {
  position @0 :Vec3 $example("[0,5,-20]");  # position of the player's feet on arrival
  yaw @1 :Float32;             # radians, used if `turns` is true
  turns @2 :Bool;              # if true, the player faces `yaw` afterwards
  keepVelocity @3 :Bool;       # if false, the player arrives at rest
}

struct Boost {
  # Changes the player's speed of walking or jumping, or the player's gravity, for a time. If several boosts change the
  # same value, the one touched last applies.
  walkSpeed @0 :Float32 = 1 $example("2");  # factor of PhysicsParams.walkSpeed; above 0, at most 100
  jumpSpeed @1 :Float32 = 1;  # factor of PhysicsParams.jumpSpeed; above 0, at most 100
  jumpMore @2 :Float32;       # studs/s added to the jump speed, -1000 to 1000
  seconds @3 :Float32;        # duration after the last touch; 0 for only while the part is touched
  forever @4 :Bool;           # if true, it lasts until the attempt ends
  gravity @5 :Float32 = 1;    # factor of PhysicsParams.gravity, for the player only; 0 to 100, and the product at most 2000
  resets @6 :Bool;            # if true, values left at 1 return to the level's own, even after another boost
}

struct OneWay {
  # The part is solid only for players on the side that `direction` points to.
  direction @0 :Vec3 = (x = 0, y = 1, z = 0);  # in the part's frame
}

enum Squeeze {
  # The effect on a player squeezed between this part and another one.
  push @0;
  kill @1;
}

struct Seat {
  # A touch seats the player until jump is pressed.
}

struct Trip {
  seconds @0 :Float32 = 3;  # seconds without control after the touch
  after @1 :Float32 = 1;    # seconds after that until it can trip the player again
}

struct Checkpoint {
  stage @0 :Int32 $example("1");  # 1, 2, ... in order of play
}

struct Goal {
  stage @0 :Int32;    # 0 for the end of the level
}

enum Easing {
  linear @0; sine @1; back @2; quad @3; quart @4; quint @5; bounce @6; elastic @7; exponential @8; circular @9; cubic @10;
}

enum EasingDirection {
  in @0; out @1; inOut @2;
}

enum Repeat {
  once @0;
  loop @1;       # jumps back to the first key after the last one
  pingPong @2;   # runs back through the keys after the last one
}

enum MotionTrigger {
  always @0;    # driven by the level's clock
  touch @1;     # rests at the first key until touched
  signal @2;    # rests at the first key while the signal does not last
}

struct MotionKey {
  # The part has this pose at `time`. The movement from the key before follows the easing.
  time @0 :Float32;       # seconds, not decreasing; the motion starts at the first key, even if its time is not 0
  position @1 :Vec3;      # world frame
  rotation @2 :Quat;      # world frame
  easing @3 :Easing;
  direction @4 :EasingDirection = out;
}

struct Spin {
  axis @0 :Vec3 = (x = 0, y = 1, z = 0);  # in the part's frame
  speed @1 :Float32;                      # rad/s, right-handed about the axis
  pivot @2 :Vec3;                         # fixed point, relative to the part's centre and in its frame
}

struct Motion {
  # One pass through the keys takes at most 20 minutes (there and back for pingPong), and so does one turn of the spin.
  keys @0 :List(MotionKey);   # if empty, the part stays at its pose
  repeat @1 :Repeat = loop;
  spin @2 :Spin;              # added to the keys
  offset @3 :Float32;         # seconds into the motion at tick 0; if negative, `once` waits that long, others count back
  carries @4 :Bool;           # true if driven by physics, which carries a standing player; false for a tween or CFrame loop
  trigger @5 :MotionTrigger;
  signal @6 :Text;            # signal: name given by its buttons
  seconds @7 :Float32;        # touch: seconds until it rests again; at 0, `once` stays at its last key, others do one repetition
}

# ---------------------------------------------------------------------------------------------- physics parameters

struct PhysicsParams {
  # All numbers in which a real engine may differ. lib/level/params.h has the same fields, and a test checks that they
  # agree. docs/physics.md explains each field.
  gravity @0 :Float32 = 196.2 $unit("studs/s^2") $range((min = 0, max = 2000)) $source("measured, n > 300,000; Workspace.Gravity");
  walkSpeed @1 :Float32 = 16 $unit("studs/s") $range((min = 0, max = 500)) $source("H Humanoid.WalkSpeed");
  jumpSpeed @2 :Float32 = 53 $unit("studs/s") $range((min = 0, max = 1000))
    $source("measured, n = 2,032: 1.06 x JumpPower, or sqrt(2 g JumpHeight)");
  maxSlope @3 :Float32 = 1.5533431 $unit("rad") $range((min = 0, max = 1.5533431)) $source("H Humanoid.MaxSlopeAngle 89 degrees");
  maxHealth @4 :Float32 = 100 $unit("health") $range((min = 1, max = 1000000)) $source("H Humanoid.MaxHealth");
  healthRegeneration @5 :Float32 = 0.01 $unit("share of maxHealth/s") $range((min = 0, max = 10)) $source("H default Health script");
  fallenPartsHeight @6 :Float32 = -500 $unit("studs") $range((min = -50000, max = 50000)) $source("H Workspace.FallenPartsDestroyHeight");
  controlRate @7 :UInt16 = 60 $unit("1/s") $range((min = 10, max = 480)) $source("H Humanoid logic runs per rendered frame");
  substeps @8 :UInt16 = 4 $unit("physics steps per tick") $range((min = 1, max = 16)) $source("measured, n > 300,000: 240 Hz world steps");

  hipHeight @9 :Float32 = 2 $unit("studs") $range((min = 0, max = 20)) $source("H leg length of the canonical test body");
  rootHeight @10 :Float32 = 2 $unit("studs") $range((min = 0.1, max = 20)) $source("H HumanoidRootPart.Size.Y");
  bodyWidth @11 :Float32 = 2 $unit("studs") $range((min = 0.1, max = 20)) $source("H torso Size.X");
  bodyDepth @12 :Float32 = 1 $unit("studs") $range((min = 0.1, max = 20)) $source("H torso Size.Z");
  bodyTop @13 :Float32 = 5 $unit("studs above the feet") $range((min = 0.5, max = 40)) $source("H top of Head");
  headBottom @14 :Float32 = 4 $unit("studs above the feet") $range((min = 0.4, max = 40)) $source("H bottom of Head");
  armSpan @15 :Float32 = 4 $unit("studs") $range((min = 0.1, max = 40)) $source("H torso and both arms, R6");
  touchMargin @16 :Float32 = 0.05 $unit("studs") $range((min = 0, max = 1)) $source("L limbs touch the part below them");

  traction @17 :Float32 = 2060 $unit("studs/s^2 per friction") $range((min = 1, max = 20000)) $source("measured, R6: ground acceleration is this times the pair friction of floor and body");
  airAccel @18 :Float32 = 143 $unit("studs/s^2") $range((min = 0, max = 5000)) $source("measured, n = 66,000");
  moveGain @19 :Float32 = 150 $unit("1/s") $range((min = 1, max = 1000)) $source("measured with airAccel and traction");
  turnGain @20 :Float32 = 8.4 $unit("1/s") $range((min = 0.1, max = 1000)) $source("measured, n = 98,000");
  turnSpeed @21 :Float32 = 8 $unit("rad/s") $range((min = 0.1, max = 1000)) $source("measured in Freefall, its only use");

  hoverStiffness @22 :Float32 = 3000 $unit("1/s^2") $range((min = 1, max = 20000)) $source("measured, n = 5,210: of legs shorter than at rest");
  hoverDamping @23 :Float32 = 110 $unit("1/s") $range((min = 0, max = 2000)) $source("measured, n = 5,210");
  hoverLimit @24 :Float32 = 20000 $unit("studs/s^2") $range((min = 1, max = 1000000)) $source("M numerical guard: max upward acceleration of the hover spring");

  floorRaySpread @25 :Float32 = 0.4 $unit("share of root size") $range((min = 0, max = 1)) $source("M two independent ports agree");
  floorRayStart @26 :Float32 = 0.4 $unit("share of root height below the root centre") $range((min = 0, max = 1)) $source("M");
  floorReachBase @27 :Float32 = 0.55 $unit("share of root height") $range((min = 0, max = 1)) $source("measured: the fit to floors acquired at 1.10 (n = 494) and kept to 1.9 studs (n = 5)");
  floorKeep @28 :Float32 = 1.5 $unit("x hipHeight") $range((min = 1, max = 3)) $source("H reach if a floor was sensed last tick");
  floorAcquire @29 :Float32 = 1.1 $unit("x hipHeight") $range((min = 1, max = 3)) $source("H reach otherwise");
  fastFall @30 :Float32 = 100 $unit("studs/s") $range((min = 1, max = 10000)) $source("H reach grows with speed above this");

  landedTime @31 :Float32 = 0.05 $unit("s") $range((min = 0, max = 1)) $source("measured: Landed lasts 12 physics steps, the landing tick included, without a jump");
  coyoteTime @32 :Float32 = 0.117 $unit("s") $range((min = 0, max = 1)) $source("measured, n = 111: a jump is accepted this long after leaving the floor");
  offFloorGrace @33 :Float32 = 0.117 $unit("s") $range((min = 0, max = 1)) $source("measured: Running turns to Freefall after 28 physics steps");

  playerFrictionWeight @34 :Float32 = 1 $unit("weight") $range((min = 0, max = 100)) $source("measured; of playerFriction in the mean with a floor");
  climbSpeed @35 :Float32 = 0.7 $unit("x walkSpeed") $range((min = 0, max = 10)) $source("measured");
  climbReach @36 :Float32 = 1.2 $unit("studs") $range((min = 0, max = 5)) $source("H forward climb sensor");
  contactSkin @37 :Float32 = 0.01 $unit("studs") $range((min = 0, max = 0.2)) $source("M depth left between bodies at rest");
  maxFallSpeed @38 :Float32 = 480 $unit("studs/s") $range((min = 10, max = 2000)) $source("M numerical guard, never reached in a level");
  oneWaySlack @39 :Float32 = 0.1 $unit("studs") $range((min = 0, max = 2)) $source("L depth in a one-way part that still counts as outside");
  squeezeDepth @40 :Float32 = 0.25 $unit("studs") $range((min = 0, max = 5)) $source("L a player is squeezed if more overlap than this remains after push-out");
  squeezeTime @41 :Float32 = 0.05 $unit("s") $range((min = 0, max = 10)) $source("L a crushing part kills a player squeezed for this long");
  seatHeight @42 :Float32 = 2 $unit("studs from the seat's centre to the root's") $range((min = 0, max = 20)) $source("H Seat welds the root 2 studs above");
  seatCooldown @43 :Float32 = 3 $unit("s") $range((min = 0, max = 60)) $source("H Seat: 3 s after leaving");
  playerMass @44 :Float32 = 12.6 $unit("density x cubic studs") $range((min = 0.1, max = 1000)) $source("M the R6 assembly: 18 cubic studs x 0.7");
  pushForce @45 :Float32 = 100000 $unit("mass x studs/s^2") $range((min = 0, max = 10000000)) $source("L max force of a player on a dynamic part; at the default only the drive's own limit applies");
  sleepSpeed @46 :Float32 = 0.5 $unit("studs/s") $range((min = 0, max = 10)) $source("L dynamic parts slower than this come to rest");
  sleepTime @47 :Float32 = 0.5 $unit("s") $range((min = 0, max = 10)) $source("L dynamic parts come to rest after this long below sleepSpeed");
  climbLowest @48 :Float32 = 0.25 $unit("share of hipHeight") $range((min = 0, max = 1)) $source("L lowest row of the climb sensor: legs that sink into a floor of trusses do not reach the next truss");
  climbWill @49 :Float32 = 0.01 $unit("share of the move direction") $range((min = 0, max = 1)) $source("H into the truss or away from it: dot product of +-0.01");
  playerFriction @50 :Float32 = 0.3 $unit("friction") $range((min = 0, max = 2)) $source("measured with traction: of the body, in the mean with the floor");
  jumpAccel @51 :Float32 = 0 $unit("studs/s^2") $range((min = 0, max = 5000)) $source("measured: keys have no effect while Jumping");
  airJumps @52 :UInt16 = 0 $unit("jumps in the air between two floors; 100: any number") $range((min = 0, max = 100)) $source("H none without a script");
}

# ---------------------------------------------------------------------------------------------- query

struct Start {
  # The player starts with the feet at the centre of the region's floor. Without a region, the player starts at one of
  # the level's spawns and faces as that spawn does.
  region @0 :Region;
  spawn @1 :Int32 = -1;     # index into the level's spawns, if there is no region; -1 for the first
  yaw @2 :Float32;          # radians, if there is a region
  tick @3 :UInt32;          # level clock at the start, which determines the positions of moving parts
}

struct Waypoint {
  region @0 :Region;
  maxJumps @1 :Int32 = -1;      # max jumps from the start until arrival; -1 for any
  segmentJumps @2 :Int32 = -1;  # max jumps since the previous waypoint, or the start; -1 for any
  timeLimit @3 :Float32;        # max seconds of game time from the start until arrival; 0 for any
  segmentTime @4 :Float32;      # max seconds since the previous waypoint, or the start; 0 for any
}

enum Arrive {
  # The way to reach a solid part. A box, or a part that is not solid, is reached by entering it.
  stand @0;  # stand on it, sit on it or hold on to it
  touch @1;  # have the body in the space around it; grazing its side while falling past it counts
}

enum Directions {
  # Directions in which the player can walk, seen from above.
  any @0;       # all directions, as with a thumbstick, or a camera that turns
  keyboard @1;  # eight directions relative to the facing at the start, as with keys and a camera that stays behind
}

struct Query {
  id @0 :Text;
  title @23 :Text;          # start and goal in words, for display; no answer depends on it
  level @1 :Text;           # name of the level record; empty for the last level before the query
  start @2 :Start;          # if absent, the level's first spawn
  goal @3 :Region;
  waypoints @4 :List(Waypoint);  # in this order; at most 255
  avoid @5 :List(Region);
  maxJumps @6 :Int32 = -1;  # -1 for any
  timeLimit @7 :Float32;    # max seconds of game time; 0 for any
  goals @8 :List(Region);   # reaching any of these, or goal, ends the attempt
  visits @9 :List(Region);  # regions to visit before the goal, in any order; at most 32
  minJumps @10 :Int32;      # min jumps before the goal counts, up to 65535
  segmentJumps @11 :Int32 = -1;      # max jumps since the last waypoint; -1 for any
  segmentTime @12 :Float32;          # max seconds since the last waypoint; 0 for any
  maxDamage @13 :Float32 = -1;       # max health lost in total; -1 for any
  forbid @14 :List(PlayerState);     # any of jumping, climbing, seated, fallingDown
  arrive @17 :Arrive;                # applies to goals, waypoints and visits that name a solid part
  tricks @18 :List(Trick);           # tricks that the player may use
  bodies @19 :List(Text);            # r6, r15 or place; each must have a solution; empty for the level's physics
  frameRates @20 :List(UInt16);      # frames per second; each must have a solution; empty for the level's controlRate
  directions @22 :Directions;        # in which the player can walk
  sameKeys @21 :Bool;                # if true, one solution's keys, held by time, must work for every body and frame rate

  # Information from the maker of the level. No answer depends on these fields, but obby-train learns from them.
  route @15 :List(Vec3) $formerly("way");  # feet positions along a known route, from the start to the goal; 2 to 4096
  difficulty @16 :Float32 = -1;      # 0 is trivial, 1 a jump at the limit; -1 if not given
}

# ---------------------------------------------------------------------------------------------- answers

struct ActionRun {
  # One action held for a number of ticks.
  ticks @0 :UInt32 = 1;
  walk @1 :Bool;           # a move direction is held
  heading @2 :UInt16;      # turns/65536, counter-clockwise from above; 0 walks along -Z
  jump @3 :Bool;           # jump is held
}

enum Outcome {
  running @0;     # the attempt's budget was spent first
  goal @1;
  killed @2;      # a part killed the player
  fell @3;        # the player fell below fallenPartsHeight
  avoided @4;     # the player entered an avoid region
  jumps @5;       # a limit on jumps was exceeded
  timeout @6;     # a time limit was exceeded
  hurt @7;        # the player lost more health than allowed
  forbidden @8;   # the player was in a forbidden state
}

struct Trajectory {
  query @0 :Text $always;
  level @1 :Text;
  index @2 :UInt32 $always;          # 0, 1, ... within the query
  outcome @3 :Outcome $always;
  position @4 :Vec3;         # feet at the start
  yawTurns @5 :UInt16;       # turns/65536
  startTick @6 :UInt32;
  actions @7 :List(ActionRun);
  ticks @8 :UInt32 $always;
  jumps @9 :UInt32 $always;
  waypoints @10 :UInt32;     # waypoints reached, in order
  part @11 :Int32 = -1;      # index of the part that killed the player
  stateHash @12 :UInt64;     # hash of the final state, which a replay must reproduce
  endPosition @13 :Vec3;     # feet at the end
  avoid @14 :Int32 = -1;     # index into the query's avoid list of the region entered or part touched
  visited @15 :UInt32;       # one bit for each of the query's visits
  route @16 :List(Int32);    # parts that carried the player, in order, without repeats in a row
  difficulty @17 :Difficulty;  # difficulty of a solution, on request
  path @18 :Path;            # on request, for readers that cannot replay
  method @19 :Text;          # the search method that found it
  tricks @20 :List(Trick);   # tricks that the player may use, also in a replay
  body @21 :Text;            # body of the player; empty for the level's physics
  frameRate @22 :UInt16;     # ticks per second; 0 for the level's controlRate
  doubtful @23 :List(Int32); # parts with doubts that a solution stands on or touches, in order of first touch
}

struct Path {
  # The positions along a trajectory.
  step @0 :UInt32 $always;      # ticks between two points; 6 are 0.1 s at 60 ticks/s
  points @1 :List(Vec3);        # positions of the feet, from the start to the end
  jumpTicks @2 :List(UInt32);   # ticks since the start, one for each jump
  ticks @3 :UInt32;             # ticks since the start at the last point, at most a step after the previous point
}

enum Band {
  # The difficulty of a step for a player of the noise model. It ranks steps, but is not a share of players.
  trivial @0;
  easy @1;
  medium @2;
  hard @3;
  extreme @4;
}

struct Difficulty {
  # The reliability of a solution, from trials with noise on the player's actions (docs/answers.md explains it).
  band @0 :Band $always;          # band of the hardest step
  success @1 :Float32;            # share of trials that pass all steps, each trial from its step's own start
  expectedAttempts @2 :Float32;   # 1 / success, at most 1e6; a step that no trial passes counts as half a trial
  hardest @3 :UInt32;             # index into steps
  steps @4 :List(DifficultyStep);
  trials @5 :UInt32;              # number of trials per step
  noise @6 :Text;                 # the player model and its numbers
}

struct DifficultyStep {
  # A step from one support to the next.
  startTick @0 :UInt32 $always;   # ticks since the start of the trajectory
  ticks @1 :UInt32 $always;
  from @2 :Int32 = -1;            # the part that carries the player at the start; -1 for none
  to @3 :Int32 = -1;              # the part that carries the player at the end; -1 for the goal
  jumps @4 :UInt32;
  band @5 :Band $always;
  success @6 :Float32;            # share of trials that come to rest on `to`, or reach the goal
  window @7 :Float32;             # milliseconds in which the tightest jump can be pressed, at most 41 ticks; 0 without a jump, or if it fails even as recorded
  margin @8 :Float32;             # studs from the landing point of the feet to the nearest edge of `to`; negative beyond it; 0 without a landing
  clearance @9 :Float32 = -1;     # min distance to a kill part, studs; -1 for none within 10
}

struct Progress {
  # Written while a search runs. This record and Result.timing are the only data that depend on the machine.
  query @0 :Text;
  seconds @1 :Float32;
  steps @2 :UInt64;
  cells @3 :UInt64;
  rounds @4 :UInt64;
  closest @5 :Float32;       # min distance so far to the goal (or the next waypoint), studs
  waypoints @6 :UInt32;      # max waypoints and visits reached so far
  best @7 :Trajectory;       # the attempt that came closest
  newest @8 :Trajectory;     # the trajectory to the newest cell
  deaths @9 :List(Trajectory);  # the last attempts that failed in a new way or place, newest first
  solution @10 :Trajectory;     # the solution found first, before it is improved; in one record only
}

enum Verdict {
  solved @0;
  unreachable @1;   # proved by a sound bound
  unknown @2;       # the budget was spent
}

struct Timing {
  seconds @0 :Float32;        # wall-clock time of this query
  firstSolution @1 :Float32;  # seconds to the first verified solution; 0 if there is none
  stepsPerSecond @2 :Float64;
  compile @3 :Float32;        # seconds to compile the level
}

struct Tally {
  outcome @0 :Outcome $always;
  part @1 :Int32 = -1;
  count @2 :UInt64;
  avoid @3 :Int32 = -1;    # index into the query's avoid list
}

struct Cut {
  # The reason why a query is unreachable: an upper bound on the parts within reach, and the first missing step on the
  # route that lacks the least.
  reached @0 :List(Int32);   # indices of the parts that may carry the player
  from @1 :Int32 = -1;       # the part where the step begins; -1 for the start
  to @2 :Int32 = -1;         # the part where it ends; -1 for the goal, a waypoint or a visit
  rise @3 :Float32;          # height that a plain jump lacks, studs
  gap @4 :Float32;           # distance that a plain jump lacks, studs
  jumps @5 :UInt32;          # lower bound on the jumps needed; 0 if the limit on jumps is not the cause
  seconds @6 :Float32;       # lower bound on the game time needed; 0 if the time limit is not the cause
  withTricks @7 :Bool;       # true if this also holds for players who use every trick
  mayHelp @8 :List(Trick);   # if not, the tricks that each prevent the proof by themselves
}

enum Saturation {
  growing @0;    # the search still finds new cells, so more time may solve the query
  saturated @1;  # twice the rollouts would hardly find a new cell, at this resolution
}

struct SearchEvidence {
  # The coverage of a search that found no solution.
  saturation @0 :Saturation $always;
  rollouts @1 :UInt64;
  idleRollouts @2 :UInt64;      # rollouts since the last new cell
  singletons @3 :UInt64;        # cells seen exactly once
  newCellChance @4 :Float32;    # upper bound on the chance that the next rollout finds a new cell (Good-Turing, 97.5 %)
  coverage @5 :List(Coverage);  # coverage during the search, each time the number of steps doubled
}

struct Coverage {
  steps @0 :UInt64;
  cells @1 :UInt64;
  closest @2 :Float32;          # min distance so far to the goal (or the next waypoint), studs
}

struct HeatMap {
  # The places that a search has explored, in a grid of cubes.
  size @0 :Float32;          # edge of a cube, studs: 2, doubled until there are at most 4,096 cubes
  cubes @1 :List(HeatCube);
}

struct HeatCube {
  feet @0 :Vec3;             # the lowest position of the feet in the cube
  cells @1 :UInt32;          # cells of the search in the cube
}

enum RelaxationKind {
  jumps @0;       # the limit on jumps is raised
  time @1;        # the time limit is raised, seconds
  jumpHeight @2;  # the player jumps higher, studs
  lowered @3;     # a part is lowered, studs
  killPart @4;    # a part that kills or hurts is removed
  avoid @5;       # an avoid region is removed
  damage @6;      # the limit on damage is raised, health
  forbidden @7;   # a forbidden state is allowed
}

struct Relaxation {
  # A change that makes a query solvable, the smallest one found of its kind.
  kind @0 :RelaxationKind $always $formerly("knob");
  amount @1 :Float32;           # size of the change in the unit of its kind; 0 if the limit, part or region is removed
  part @2 :Int32 = -1;
  avoid @3 :Int32 = -1;         # index into the query's avoid list
  steps @4 :UInt64;             # simulated ticks to the solution of the changed query
  text @5 :Text;                # the change in words
  field @6 :Text;               # changed field of the query record, "waypoints[1].segmentJumps"; empty if the level changes
}

struct RouteCount {
  # Solutions with the same route.
  route @0 :List(Int32);        # as in Trajectory
  count @1 :UInt64 $always;
  ticks @2 :UInt32 $always;     # ticks of the shortest one
}

struct Result {
  query @0 :Text $always;
  level @1 :Text;
  verdict @2 :Verdict $always;
  solutions @3 :UInt32 $always;
  ticks @4 :UInt32 $always;          # ticks of the first solution in the list, which is the best
  jumps @5 :UInt32 $always;          # jumps of that solution
  steps @6 :UInt64;
  cells @7 :UInt64;
  rounds @8 :UInt64;
  closest @9 :Float32;       # min distance to the goal, studs; 0 if solved
  reason @10 :Text;          # the answer in one sentence
  ends @11 :List(Tally);     # outcomes of the attempts, most frequent first
  timing @12 :Timing;
  method @13 :Text;
  seed @14 :UInt64;
  cut @15 :Cut;              # only if unreachable
  evidence @16 :SearchEvidence;    # only if unknown
  relaxations @17 :List(Relaxation);  # only if there is no solution, on request
  routes @18 :List(RouteCount);       # routes of the solutions, most frequent first
  heatMap @19 :HeatMap;      # heat map of a search, on request
  tricks @20 :List(Trick);   # tricks that the query allows
  players @21 :List(PlayerAnswer);  # only if the query names bodies or frame rates
  holds @22 :Bool = true;    # false if the first solution depends on a loss of the import
  doubts @23 :List(Doubt);   # the reasons why `holds` is false
}

struct Doubt {
  # A loss of the import that a solution depends on.
  kind @0 :Text;         # as in Unmodelled
  part @1 :Int32 = -1;   # part that the solution stands on or touches; -1 if the loss concerns no single part
}

struct PlayerAnswer {
  # The answer for one body at one frame rate.
  body @0 :Text;             # empty for the level's physics
  frameRate @1 :UInt16 $always;     # frames per second
  verdict @2 :Verdict $always;
  ticks @3 :UInt32;          # ticks of the first solution, at this frame rate
  jumps @4 :UInt32;          # jumps of that solution
  reason @5 :Text;           # the answer in one sentence
}

# ---------------------------------------------------------------------------------------------- recordings, metrics

struct RecordedPose {
  position @0 :Vec3;     # centre of the part, world frame
  rotation @1 :Quat;     # world frame
}

struct RecordingFrame {
  time @0 :Float64;      # seconds since the first frame
  move @1 :Vec3;         # the player's move direction, world frame, length 0 to 1
  jump @2 :Bool;
  position @3 :Vec3;     # centre of the root part
  velocity @4 :Vec3;
  state @5 :Text;        # HumanoidStateType name
  facing @6 :Vec3;       # look vector of the root part, world frame; zero if not recorded
  poses @7 :List(RecordedPose);  # poses of the recording's parts, in the same order; empty if unchanged since the previous frame
}

struct Recording {
  # Actions and positions sampled in the real engine.
  name @0 :Text;
  level @1 :Text;
  rate @2 :Float32;      # frames per second, nominal
  frames @3 :List(RecordingFrame);
  engine @4 :Text;       # the program that recorded it, and its version
  parts @5 :List(Text);  # the moving and dynamic parts in the frames' poses, each named as in Region.part
}

struct Metric {
  name @0 :Text;
  value @1 :Float64;
  unit @2 :Text;
}

struct Metrics {
  source @0 :Text;       # tool and task
  step @1 :UInt64;
  values @2 :List(Metric);
}
