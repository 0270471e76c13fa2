// The same bodies in our simulator and in Bullet's (double precision, 240 steps a second). In both,
// friction is the mean of the two surfaces, and nothing bounces.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "parity/bullet.h"
#include "sim/play.h"

namespace obby::parity {

struct BodySpec {
  schema::Shape shape = schema::Shape::BLOCK;
  Vec3 position{}, size{};
  float yaw = 0, pitch = 0, friction = 0.5f;
  bool anchored = false;
  Vec3 velocity{}, spin{};
  Vec3 travel{};  // motion of an anchored carrier in four seconds, in studs
};

struct BodyState {
  Vec3 position, velocity;
  Mat3 axes;
};

constexpr float kTravelSeconds = 4;

class OurBodies {
 public:
  explicit OurBodies(const std::vector<BodySpec>& specs)
      : level_(levelOf(specs)), play_(level_, {0, 0, 150}) {
    size_t bodies = 0;
    for (const BodySpec& s : specs) {
      if (s.anchored) continue;
      play_.bodies[bodies].velocity = s.velocity;
      play_.bodies[bodies++].spin = s.spin;
    }
  }
  void run(int ticks = 1) { play_.run(test::stand(), ticks); }
  BodyState state(size_t i) const {
    const Pose pose = poseOf(play_.bodies[i], level_.view().bodies[i]);
    return {pose.position, play_.bodies[i].velocity, pose.rotation};
  }
  const sim::RigidBody& body(size_t i) const { return play_.bodies[i]; }
  const level::DynamicBody& table(size_t i) const { return level_.view().bodies[i]; }
  bool asleep() const { return !(play_.world.flags & sim::kBodyAwake); }

 private:
  // Adds a floor far below for the player, which also catches bodies that fall.
  static level::Level levelOf(const std::vector<BodySpec>& specs) {
    support::LevelBuilder b;
    for (const BodySpec& s : specs) {
      b.block(s.position, s.size, [s](auto p) {
        p.setShape(s.shape), p.setFriction(s.friction), p.setElasticity(0);
        p.setAnchored(s.anchored);
        support::setRotation(p.initRotation(), s.yaw, s.pitch);
        if (dot(s.travel, s.travel) > 0) setTravel(p, s);
      });
    }
    return b.spawn({0, 0, 150}).compile();
  }
  static void setTravel(schema::Part::Builder p, const BodySpec& s) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), s.position);
    keys[1].setTime(kTravelSeconds);
    support::set(keys[1].initPosition(), s.position + s.travel);
  }

  level::Level level_;
  test::Play play_;
};

class BulletBodies {
 public:
  // Masses and centres are ours, which tests/level compares with formulas. Inertia is Bullet's own.
  BulletBodies(const std::vector<BodySpec>& specs, const OurBodies& ours)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadPhase_, &solver_, &configuration_) {
    gCalculateCombinedFrictionCallback = meanFriction;
    gCalculateCombinedRestitutionCallback = noBounce;
    world_.setGravity({0, -196.2, 0});
    size_t bodies = 0;
    for (const BodySpec& s : specs) {
      const level::DynamicBody* table = s.anchored ? nullptr : &ours.table(bodies++);
      add(s, table);
    }
  }
  ~BulletBodies() {
    for (auto& b : bodies_) world_.removeRigidBody(b.get());
  }

  void run(int ticks = 1) {
    for (int i = 0; i < 4 * ticks; ++i) {
      ++steps_;
      for (const Mover& m : movers_) {
        btTransform at = m.body->getWorldTransform();
        const btScalar part = steps_ / btScalar(240 * kTravelSeconds);
        at.setOrigin(bulletVector(m.spec.position) + bulletVector(m.spec.travel) * part);
        m.body->setWorldTransform(at);
      }
      world_.stepSimulation(1.0 / 240, 0);
    }
  }
  BodyState state(size_t i) const {
    const btRigidBody& b = *bodies_[dynamic_[i]];
    const btTransform t = b.getWorldTransform() * centers_[dynamic_[i]].inverse();
    const auto narrow = [](const btVector3& v) {
      return Vec3{float(v.x()), float(v.y()), float(v.z())};
    };
    const btMatrix3x3& m = t.getBasis();
    return {narrow(t.getOrigin()),
            narrow(b.getLinearVelocity()),
            {narrow(m.getColumn(0)), narrow(m.getColumn(1)), narrow(m.getColumn(2))}};
  }

 private:
  static btScalar meanFriction(const btCollisionObject* a, const btCollisionObject* b) {
    return 0.5 * (a->getFriction() + b->getFriction());
  }
  static btScalar noBounce(const btCollisionObject*, const btCollisionObject*) { return 0; }

  static geom::ShapeKind kindOf(schema::Shape s) { return geom::ShapeKind(int(s)); }

  static btQuaternion turnOf(const BodySpec& s) {
    capnp::MallocMessageBuilder message;
    auto q = message.initRoot<schema::Quat>();
    support::setRotation(q, s.yaw, s.pitch);
    return {btScalar(q.getX()), btScalar(q.getY()), btScalar(q.getZ()), btScalar(q.getW())};
  }

  // Adds a body. Bullet expects its shape relative to the centre of mass.
  void add(const BodySpec& s, const level::DynamicBody* table) {
    btTransform part(turnOf(s), bulletVector(s.position));
    btTransform center = btTransform::getIdentity();
    if (table) center.setOrigin(bulletVector(table->center));
    shapes_.push_back(bulletShape(kindOf(s.shape), {s.size * 0.5f, nullptr}));
    btCollisionShape* shape = shapes_.back().get();
    auto whole = std::make_unique<btCompoundShape>();
    if (table && length(table->center) > 0) {
      whole->addChildShape(center.inverse(), shape);
      shape = whole.get();
    }
    const btScalar mass = table ? 1 / btScalar(table->inverseMass) : 0;
    btVector3 inertia(0, 0, 0);
    if (table) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform = part * center;
    info.m_friction = btScalar(s.friction);
    auto body = std::make_unique<btRigidBody>(info);
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setLinearVelocity(bulletVector(s.velocity));
    body->setAngularVelocity(bulletVector(s.spin));
    if (dot(s.travel, s.travel) > 0) {
      body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
      movers_.push_back({body.get(), s});
    }
    world_.addRigidBody(body.get());
    if (table) dynamic_.push_back(bodies_.size());
    bodies_.push_back(std::move(body));
    centers_.push_back(center);
    compounds_.push_back(std::move(whole));
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadPhase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btCompoundShape>> compounds_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<btTransform> centers_;
  std::vector<size_t> dynamic_;
  struct Mover {
    btRigidBody* body;
    BodySpec spec;
  };
  std::vector<Mover> movers_;
  int steps_ = 0;
};

// The same bodies, simulated by both engines.
struct Both {
  OurBodies ours;
  BulletBodies bullet;
  explicit Both(const std::vector<BodySpec>& specs) : ours(specs), bullet(specs, ours) {}
  void run(int ticks) { ours.run(ticks), bullet.run(ticks); }
};

}  // namespace obby::parity
