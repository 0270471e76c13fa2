# A checkpoint of obby-train: everything that decides what it learns next, so that learning that was broken off goes on as
# if nothing had been.
#
# One Cap'n Proto message, not packed. Settings and levels are not in it: they are given anew, and `settings` and the
# levels' hashes say whether they are the same. Levels are made anew by their numbers.
@0xa9d40f6e2b7c3158;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

struct SavedTraining {
  hash @0 :UInt64;     # XXH3 (64 bit) over the whole file with these eight bytes as 0
  version @1 :UInt32;  # of this layout: 5
  observationVersion @2 :UInt32;  # as in policy.capnp
  stateLayout @3 :UInt64;  # XXH3 over names, types and sizes of the fields of sim::World and sim::LooseBody
  program @4 :Text;    # version of the program, for people
  settings @5 :List(SavedSetting);
  seconds @6 :Float64;  # wall clock so far, of all runs; nothing is decided by it
  iterations @7 :UInt64;
  decisions @8 :UInt64;
  solved @9 :Float64;   # share of playthroughs solved, smoothed
  hardest @10 :Float32;  # difficulty of the levels that come next, at most
  seen @11 :SavedSums;  # of observations
  learner @12 :SavedLearner;
  crowds @13 :List(SavedCrowd);  # those of rank 0, then of rank 1, ...
  history @14 :SavedHistory;     # for the learning curve; nothing is decided by it
}

struct SavedSetting {
  name @0 :Text;
  value @1 :Text;  # numbers as their shortest decimal that reads back the same
}

struct SavedHistory {
  each @0 :UInt32;        # iterations a point
  iterations @1 :UInt32;  # since the last point
  reward @2 :Float64;     # their sum
  points @3 :List(SavedPoint);
}

struct SavedPoint {
  decisions @0 :UInt64;
  solved @1 :Float32;
  hardest @2 :Float32;
  reward @3 :Float32;  # a decision, mean since the last point
}

struct SavedSums {
  sum @0 :List(Float64);
  squares @1 :List(Float64);
  rows @2 :Float64;
}

struct SavedLearner {
  # Weights and the means of gradients and their squares (Adam): for each layer (inputs, outputs), then its biases.
  weights @0 :List(Float32);
  momentum @1 :List(Float32);
  squares @2 :List(Float32);
  steps @3 :UInt64;  # of Adam
  valueMean @4 :Float32;  # of the value head (Pop-Art)
  valueDeviation @5 :Float32;
  returns @6 :SavedSums;
}

struct SavedCrowd {
  places @0 :List(SavedPlace);
}

struct SavedCrowds {
  # What a rank sends to the first one, for the file.
  crowds @0 :List(SavedCrowd);
}

struct SavedPlace {
  # A level with its worlds. Worlds and loose bodies are the bytes of sim::World (lib/sim/world.h) and sim::LooseBody
  # (lib/sim/loose.h), which have no padding, one after another.
  taken @0 :UInt64;      # levels so far, this one included: says which of the source it is
  hardest @1 :Float32;   # difficulty that it was asked for with
  levelHash @2 :UInt64;  # of the level that it must be
  played @3 :UInt32;     # playthroughs of it
  worlds @4 :Data;       # (players)
  loose @5 :Data;        # (players, loose bodies of the level)
  reached @6 :Data;      # to begin from
  least @7 :List(Float32);   # (players), studs of the way left, the least in this playthrough
  ticks @8 :List(UInt32);    # (players), of this playthrough
  fromStart @9 :List(Bool);  # (players)
  nextHardest @10 :Float32;  # difficulty that the next level will be asked for with
  reachedLeast @11 :List(Float32);  # (reached), `least` of whoever stood there
  solvedOnce @12 :Bool;  # somebody has solved the level from the start
}
