# A policy file (policy.obp): a trained network, what is needed to use it, and how it was trained.
#
# One Cap'n Proto message, not packed. Numbers are little-endian floats in the order in which they are read. `hash`
# is XXH3 (64 bit) over the bytes of means, scales, and each layer's weights and biases, in that order.
@0xd3b1a7f20c5e4986;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("obby::schema");

struct PolicyFile {
  version @0 :UInt32;             # of this layout: 1
  observationVersion @1 :UInt32;  # what the inputs mean: kObservationVersion of lib/policy/observation.h
  moves @2 :UInt32;               # logits of the last layer; the value follows them, then padding
  means @3 :List(Float32);        # an input is clamped to (raw - mean) x scale, at most 5 either way
  scales @4 :List(Float32);
  layers @5 :List(PolicyLayer);   # rectified, except the last
  hash @6 :UInt64;
  training @7 :PolicyTraining;
  valueMean @8 :Float32;       # the value's output stands for a reward of mean + deviation x output. Not hashed: only
  valueDeviation @9 :Float32;  # training that starts from the policy uses them. Deviation 0: unknown, as in older files
}

struct PolicyLayer {
  inputs @0 :UInt32;
  outputs @1 :UInt32;
  weights @2 :List(Float32);  # (inputs, outputs)
  biases @3 :List(Float32);   # (outputs)
}

struct PolicyTraining {
  # For information, except that normalisers have the weight of `decisions` when training starts from the policy.
  command @0 :Text;
  version @1 :Text;       # of the program
  seed @2 :UInt64;
  decisions @3 :UInt64;   # decisions it learned from, with those of the policy it started from
  seconds @4 :Float64;    # wall-clock time
  hardest @5 :Float32;    # max difficulty of its levels at the end
  solved @6 :Float32;     # share of playthroughs solved at the end
  start @7 :Text;         # hash of the policy it started from; empty: none
}
