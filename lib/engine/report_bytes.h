// Serializes reports that a child sends to its parent. Private to lib/engine.
#pragma once

#include <string>
#include <utility>

#include "engine/archive.h"
#include "engine/report.h"

namespace obby::engine {

// ADL finds these for the archives.
template <class A>
void fields(A& a, Change& c) {
  a(c.time), a(c.target), a(c.property), a(c.value), a(c.line);
}
template <class A>
void fields(A& a, Track& t) {
  a(t.start), a(t.poses), a(t.line), a(t.driver);
}
template <class A>
void fields(A& a, TweenChange& w) {
  a(w.property), a(w.from), a(w.to);
}
template <class A>
void fields(A& a, Tween& t) {
  a(t.time), a(t.id), a(t.target), a(t.seconds), a(t.delay), a(t.style), a(t.direction),
      a(t.repeats);
  a(t.reverses), a(t.changes), a(t.line);
}
template <class A>
void fields(A& a, Problem& p) {
  a(p.script), a(p.text), a(p.count), a(p.failure);
}
template <class A>
void fields(A& a, Heed& h) {
  a(h.target), a(h.line);
}
template <class A>
void fields(A& a, MadePart& m) {
  a(m.id), a(m.origin), a(m.parent), a(m.className), a(m.name), a(m.properties), a(m.references);
  a(m.later);
}
template <class A>
void fields(A& a, Observation& o) {
  a(o.changes), a(o.tracks), a(o.tweens), a(o.harms), a(o.problems), a(o.counts), a(o.player);
  a(o.frames), a(o.random), a(o.heeded), a(o.happened);
}
template <class A>
void fields(A& a, SecondLook& l) {
  a(l.harms), a(l.left);
}
template <class A>
void fields(A& a, Probe& p) {
  a(p.brief), a(p.still);
  a(p.target), a(p.approach), a(p.at), a(p.left), a(p.seen), a(p.lost), a(p.byPlace), a(p.allOver),
      a(p.byRoot), a(p.byFall), a(p.listenerHash), a(p.sleeps), a(p.reborn), a(p.rebornAt);
}
template <class A>
void fields(A& a, SameListeners& l) {
  a(l.target), a(l.probe);
}
template <class A>
void fields(A& a, Revisit& r) {
  a(r.probe), a(r.cause), a(r.lever);
}
template <class A>
void fields(A& a, Report& r) {
  a(r.undisturbed), a(r.probes), a(r.sameListeners), a(r.revisits), a(r.made);
  a(r.collisionGroups), a(r.arrived), a(r.moves), a(r.airJumps), a(r.probedAt);
  a(r.lookedAgainAt), a(r.complete), a(r.over), a(r.sleeps), a(r.failure), a(r.culprit);
}

template <class T>
std::string toBytes(T value) {
  BytesOut out;
  out(value);
  return std::move(out.bytes);
}

// Returns false if bytes are missing, as from a child that died.
template <class T>
bool fromBytes(const std::string& bytes, T& value) {
  BytesIn in(bytes);
  if (bytes.empty()) return false;
  in(value);
  return in.good;
}

}  // namespace obby::engine
