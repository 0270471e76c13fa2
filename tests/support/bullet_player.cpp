#include "support/bullet_player.h"

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "calibrate/course_level.h"
#include "io/record.h"
#include "support/bullet_pose.h"

namespace obby::test {
namespace {

constexpr int kRate = 60, kSteps = 4;
constexpr float kLost = 10;  // studs below the start at which the recording ends
constexpr btScalar kStep = btScalar(1) / (kRate * kSteps);

Vec3 plain(const btVector3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

btTransform at(const btVector3& position) {
  btTransform out = btTransform::getIdentity();
  out.setOrigin(position);
  return out;
}

// The physics world of the level, without a player.
class Scene {
 public:
  explicit Scene(const level::LevelView& level) {
    broadphase_.getOverlappingPairCache()->setInternalGhostPairCallback(&ghosts_);
    for (uint32_t i = 0; i < level.colliderCount; ++i) {
      const level::Collider& c = level.colliders[i];
      if (c.kind != geom::ShapeKind::block || c.mover != level::kNone || c.body != level::kNoBody)
        continue;
      shapes_.push_back(std::make_unique<btBoxShape>(bulletVector(c.shape.half)));
      add(shapes_.back().get(), 0, bulletTransform(c.pose.rotation, c.pose.position));
    }
  }
  ~Scene() {
    for (const auto& body : bodies_) world.removeRigidBody(body.get());
  }

  btRigidBody* add(btCollisionShape* shape, float mass, const btTransform& where) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape);
    info.m_startWorldTransform = where;
    info.m_friction = 0;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world.addRigidBody(bodies_.back().get());
    return bodies_.back().get();
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btGhostPairCallback ghosts_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<std::unique_ptr<btBoxShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;

 public:
  btDiscreteDynamicsWorld world{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

// Returns the requested velocity without the component that walls stopped, which is derived from
// the distance of the step. Walls stop at most the component towards them. The controller also
// resolves penetration in a single step. That motion must not count as velocity, since it would
// throw the player back at up to a hundred studs/s.
btVector3 leftOf(const btVector3& asked, const btVector3& gone) {
  btVector3 pushed = gone / kStep - asked;
  pushed.setY(0);
  if (pushed.length() < SIMD_EPSILON) return asked;
  const btVector3 normal = pushed.normalized();
  return asked + normal * std::min(pushed.length(), std::max(-asked.dot(normal), btScalar(0)));
}

struct Hands {
  btVector3 wanted{0, 0, 0};  // velocity
  bool jump = false;
};

class Player {
 public:
  virtual ~Player() = default;
  virtual void step(const Hands& hands) = 0;
  virtual btVector3 position() const = 0;
  virtual bool stands() const = 0;
};

class KinematicPlayer : public Player {
 public:
  KinematicPlayer(const BulletGame& game, Scene& scene, Vec3 feet)
      : game_(game), scene_(scene), capsule_(game.radius, game.height - 2 * game.radius) {
    ghost_.setCollisionShape(&capsule_);
    ghost_.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
    controller_ = std::make_unique<btKinematicCharacterController>(
        &ghost_, &capsule_, game.stepHeight, btVector3(0, 1, 0));
    controller_->setGravity({0, -game.gravity, 0});
    controller_->setJumpSpeed(game.jumpSpeed);
    controller_->setFallSpeed(480);
    controller_->setLinearDamping(game.damping);
    // This must come last, since the calls above rotate the body.
    ghost_.setWorldTransform(at(bulletVector(feet) + btVector3(0, game.height / 2, 0)));
    scene_.world.addCollisionObject(&ghost_, btBroadphaseProxy::CharacterFilter,
                                    btBroadphaseProxy::AllFilter);
    scene_.world.addAction(controller_.get());
  }
  ~KinematicPlayer() override {
    scene_.world.removeAction(controller_.get());
    scene_.world.removeCollisionObject(&ghost_);
  }

  void step(const Hands& hands) override {
    if (hands.jump && stands()) controller_->jump();
    const bool rises = controller_->getLinearVelocity().y() > 0;
    const btScalar max = (stands() ? game_.groundAccel : game_.airAccel) * kStep;
    btVector3 lacking = hands.wanted - velocity_;
    if (lacking.length() > max) lacking *= max / lacking.length();
    // The controller lifts a moving body by this height, moves it, and puts it down again. In the
    // air, this would push the body into the part above, which would throw it half a stud in a
    // step.
    controller_->setStepHeight(stands() ? game_.stepHeight : 0);
    const btVector3 before = position(), asked = velocity_ + lacking;
    controller_->setWalkDirection(asked * kStep);
    scene_.world.stepSimulation(kStep, 0);
    velocity_ = leftOf(asked, position() - before);
    bumped_ = rises && controller_->onGround();
  }
  btVector3 position() const override { return ghost_.getWorldTransform().getOrigin(); }
  bool stands() const override { return controller_->onGround() && !bumped_; }

 private:
  const BulletGame& game_;
  Scene& scene_;
  btCapsuleShape capsule_;
  bool bumped_ = false;  // the head hit a ceiling, which the controller takes for a floor
  btPairCachingGhostObject ghost_;
  std::unique_ptr<btKinematicCharacterController> controller_;
  btVector3 velocity_{0, 0, 0};
};

class DynamicPlayer : public Player {
 public:
  DynamicPlayer(const BulletGame& game, Scene& scene, Vec3 feet)
      : game_(game), scene_(scene), capsule_(game.radius, game.height - 2 * game.radius) {
    scene_.world.setGravity({0, -game.gravity, 0});
    body_ = scene_.add(&capsule_, 1, at(bulletVector(feet) + btVector3(0, game.height / 2, 0)));
    body_->setGravity({0, -game.gravity, 0});
    body_->setAngularFactor(0);
    body_->setDamping(game.damping, 0);
    body_->setActivationState(DISABLE_DEACTIVATION);
  }

  void step(const Hands& hands) override {
    const bool standing = stands();
    btVector3 velocity = body_->getLinearVelocity();
    if (hands.jump && standing && velocity.y() < game_.jumpSpeed / 2) {
      velocity.setY(game_.jumpSpeed);
      body_->setLinearVelocity(velocity);
    }
    btVector3 lacking = hands.wanted - velocity;
    lacking.setY(0);
    body_->applyCentralForce(lacking * (standing ? game_.groundGain : game_.airGain));
    scene_.world.stepSimulation(kStep, 0);
  }
  btVector3 position() const override { return body_->getWorldTransform().getOrigin(); }
  bool stands() const override {
    constexpr btScalar kReach = btScalar(0.15);
    const btVector3 from = position(), to = from - btVector3(0, game_.height / 2 + kReach, 0);
    btCollisionWorld::ClosestRayResultCallback hit(from, to);
    hit.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
    scene_.world.rayTest(from, to, hit);
    return hit.hasHit();
  }

 private:
  const BulletGame& game_;
  Scene& scene_;
  btCapsuleShape capsule_;
  btRigidBody* body_;
};

}  // namespace

BulletGame drawnGame(BulletGame::Body body, uint64_t seed, float spread) {
  BulletGame out;
  out.body = body;
  Random random(seed, 0xb011e7);
  for (float* value : {&out.walkSpeed, &out.jumpSpeed, &out.gravity, &out.groundAccel,
                       &out.airAccel, &out.groundGain, &out.airGain})
    *value *= 1 + spread * (2 * random.unit() - 1);
  out.damping = 0.2f * random.unit();
  return out;
}

void writeBulletCourse(schema::Level::Builder to) {
  io::RecordBuilder record;
  const auto course = record.root().initLevel();
  calibrate::writeCourse(course);
  std::vector<schema::Part::Reader> blocks;
  for (const auto part : course.asReader().getParts()) {
    const bool stands = part.getAnchored() && !part.hasMotion() && !part.hasConveyor();
    if (stands && part.getShape() == schema::Shape::BLOCK) blocks.push_back(part);
  }
  to.setName(course.asReader().getName());
  to.setSpawns(course.asReader().getSpawns());
  auto parts = to.initParts(uint32_t(blocks.size()));
  for (uint32_t i = 0; i < parts.size(); ++i) {
    parts[i].setName(blocks[i].getName());
    parts[i].setPosition(blocks[i].getPosition());
    parts[i].setSize(blocks[i].getSize());
  }
}

std::vector<calibrate::Manoeuvre> bulletManoeuvres() {
  std::vector<calibrate::Manoeuvre> out = calibrate::manoeuvres();
  std::erase_if(out, [](const calibrate::Manoeuvre& m) {
    for (const char* lacking : {"ice", "climb", "step", "ramp", "belt", "ferry", "box"}) {
      if (m.name.find(lacking) != std::string::npos) return true;
    }
    return false;
  });
  return out;
}

calibrate::Track playedByBullet(const BulletGame& game, const level::Level& level,
                                const calibrate::Manoeuvre& manoeuvre) {
  Scene scene(level.view());
  std::unique_ptr<Player> player;
  if (game.body == BulletGame::Body::kinematic)
    player = std::make_unique<KinematicPlayer>(game, scene, manoeuvre.feet);
  else
    player = std::make_unique<DynamicPlayer>(game, scene, manoeuvre.feet);
  calibrate::Track track{manoeuvre.name, level.name()};
  Vec3 before = plain(player->position());
  for (const calibrate::Hold& hold : manoeuvre.holds) {
    const btVector3 stick(hold.x, 0, hold.z);
    const bool held = stick.length() > 0;
    const Hands hands{held ? stick.normalized() * game.walkSpeed : stick, hold.jump};
    for (int ticks = int(std::lround(hold.seconds * kRate)); ticks > 0; --ticks) {
      if (float(player->position().y()) < manoeuvre.feet.y - kLost) return track;
      calibrate::Frame f;
      f.time = double(track.frames.size()) / kRate;
      f.move = {hold.x, 0, hold.z};
      f.jump = hold.jump;
      f.position = plain(player->position());
      f.velocity = (f.position - before) * (1 / float(kStep));  // the velocity of the last step
      f.state = player->stands() ? sim::State::running : sim::State::freefall;
      track.frames.push_back(f);
      for (int i = 0; i < kSteps; ++i) {
        before = plain(player->position());
        player->step(hands);
      }
    }
  }
  return track;
}

}  // namespace obby::test
