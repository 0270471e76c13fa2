# A policy file (policy.obp): a trained network with all that is needed to use it, and how it came to be.
#
# One Cap'n Proto message, not packed. Numbers are little-endian floats in the order that they are read; `hash` is
# XXH3 (64 bit) over means, scales, and each layer's weights and biases, as bytes, in that order.
@0xd3b1a7f20c5e4986;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

struct PolicyFile {
  version @0 :UInt32;             # of this layout: 1
  observationVersion @1 :UInt32;  # what the inputs mean: kObservationVersion of lib/policy/observation.h
  moves @2 :UInt32;               # logits of the last layer; the value follows them, then padding
  means @3 :List(Float32);        # an input is clamped to (raw - mean) x scale, at most 5 either way
  scales @4 :List(Float32);
  layers @5 :List(PolicyLayer);   # rectified, but for the last
  hash @6 :UInt64;
  training @7 :PolicyTraining;
  valueMean @8 :Float32;       # the value's output means a reward of mean + deviation x output; not hashed, for nobody but
  valueDeviation @9 :Float32;  # learning that begins with the policy asks. Deviation 0: not known, as in older files
}

struct PolicyLayer {
  inputs @0 :UInt32;
  outputs @1 :UInt32;
  weights @2 :List(Float32);  # (inputs, outputs)
  biases @3 :List(Float32);   # (outputs)
}

struct PolicyTraining {
  # For people; nothing is decided by it, but that normalisers weigh as much as `decisions` where learning begins with the
  # policy.
  command @0 :Text;
  version @1 :Text;       # of the program
  seed @2 :UInt64;
  decisions @3 :UInt64;   # that it learned from, with those of the policy that it began with
  seconds @4 :Float64;    # wall clock
  hardest @5 :Float32;    # difficulty that its levels had at most in the end
  solved @6 :Float32;     # share of playthroughs that it solved then
  start @7 :Text;         # the policy that it began with, by its hash; empty: none
}
