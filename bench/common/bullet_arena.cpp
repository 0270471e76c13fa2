#include "common/bullet_arena.h"

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "support/bullet_pose.h"

namespace obby::bench {
namespace {

constexpr float kRadius = 1, kHeight = 5;  // studs

}  // namespace

struct BulletWorld::Impl {
  Params params;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  btRigidBody* player = nullptr;

  btRigidBody* add(std::unique_ptr<btCollisionShape> shape, float mass, const btTransform& at) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
    info.m_startWorldTransform = at;
    info.m_friction = 0;
    bodies.push_back(std::make_unique<btRigidBody>(info));
    shapes.push_back(std::move(shape));
    world.addRigidBody(bodies.back().get());
    return bodies.back().get();
  }

  ~Impl() {
    for (const auto& body : bodies) world.removeRigidBody(body.get());
  }
};

BulletWorld::BulletWorld(const level::LevelView& level, Vec3 feet)
    : impl_(std::make_unique<Impl>()) {
  impl_->params = level.params;
  impl_->world.setForceUpdateAllAabbs(false);  // static parts do not move: twice as fast
  impl_->world.setGravity({0, -level.params.gravity, 0});
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& c = level.colliders[i];
    impl_->add(std::make_unique<btBoxShape>(test::bulletVector(c.shape.half)), 0,
               test::bulletTransform(c.pose.rotation, c.pose.position));
  }
  const Pose start{feet + Vec3{0, kHeight / 2, 0}, {}};
  impl_->player = impl_->add(std::make_unique<btCapsuleShape>(kRadius, kHeight - 2 * kRadius), 1,
                             test::bulletTransform(start.rotation, start.position));
  impl_->player->setAngularFactor(0);
  impl_->player->setActivationState(DISABLE_DEACTIVATION);
}

BulletWorld::~BulletWorld() = default;
BulletWorld::BulletWorld(BulletWorld&&) noexcept = default;

void BulletWorld::step(const sim::Action& action) {
  const Params& p = impl_->params;
  btVector3 velocity = impl_->player->getLinearVelocity();
  const Vec3 walk = directionOf(sinCos(action.heading)) * (action.walk ? p.walkSpeed : 0.0f);
  const bool stands = absf(float(velocity.y())) < 0.5f;
  velocity.setX(walk.x);
  velocity.setZ(walk.z);
  if (action.jump && stands) velocity.setY(p.jumpSpeed);
  impl_->player->setLinearVelocity(velocity);
  impl_->world.stepSimulation(p.tickSeconds, 1, p.tickSeconds);
}

Vec3 BulletWorld::position() const {
  const btVector3& at = impl_->player->getWorldTransform().getOrigin();
  return {float(at.x()), float(at.y()), float(at.z())};
}

}  // namespace obby::bench
