// SPDX-License-Identifier: MIT
#include "simulation/contact/contact.hpp"
#include "study/peers/rigid_body_run.hpp"

// As it comes: its headers do not hold to our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <btBulletDynamicsCommon.h>
#pragma GCC diagnostic pop

#include <memory>

namespace frostfill
{
namespace
{

constexpr auto kBounceSpeed = static_cast<btScalar>(Restitution().bounceSpeed); ///< [sqrt(g r)]
constexpr btScalar kMass = 1;

btVector3 toBullet(const Eigen::Vector3d& v)
{
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()),
            static_cast<btScalar>(v.z())};
}

/// Bullet's world with all that it does not own itself.
class BulletWorld
{
public:
    explicit BulletWorld(const PeerTask& task)
        : restitution_(std::sqrt(static_cast<btScalar>(task.restitution))),
          world_(&dispatcher_, &broadphase_, &solver_, &configuration_)
    {
        world_.setGravity({0, -1, 0});
        world_.getSolverInfo().m_restitutionVelocityThreshold = kBounceSpeed;
        addMesh(task);
    }
    ~BulletWorld()
    {
        for (const auto& body : bodies_)
        {
            world_.removeRigidBody(body.get());
        }
    }
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    void step(double dt)
    {
        world_.stepSimulation(static_cast<btScalar>(dt), 0); // exactly one step of this length
    }
    [[nodiscard]] std::size_t size() const { return bodies_.size() - 1; }
    [[nodiscard]] std::vector<Eigen::Vector3d> places() const
    {
        std::vector<Eigen::Vector3d> places;
        for (std::size_t k = 1; k < bodies_.size(); ++k) // the first is the mesh
        {
            const btVector3& p = bodies_[k]->getWorldTransform().getOrigin();
            places.emplace_back(p.x(), p.y(), p.z());
        }
        return places;
    }

    void addSphere(const Eigen::Vector3d& place) { addBody(kMass, &sphere_, place); }

private:
    void addMesh(const PeerTask& task)
    {
        for (const auto& t : task.mesh.triangles)
        {
            triangles_.addTriangle(toBullet(task.mesh.vertices[t[0]]),
                                   toBullet(task.mesh.vertices[t[1]]),
                                   toBullet(task.mesh.vertices[t[2]]));
        }
        walls_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
        walls_->setMargin(0);
        addBody(0, walls_.get(), {0, 0, 0});
    }
    void addBody(btScalar mass, btCollisionShape* shape, const Eigen::Vector3d& place)
    {
        const btScalar inertia = mass * btScalar(0.4);
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape,
                                                      {inertia, inertia, inertia});
        info.m_startWorldTransform.setIdentity();
        info.m_startWorldTransform.setOrigin(toBullet(place));
        info.m_friction = 0;
        info.m_restitution = restitution_;
        info.m_linearSleepingThreshold = static_cast<btScalar>(kPeerStill / kPeerWindow);
        info.m_angularSleepingThreshold = 1;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        world_.addRigidBody(bodies_.back().get());
    }

    btScalar restitution_; ///< of each body; of two Bullet takes the product
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    btTriangleMesh triangles_;
    std::unique_ptr<btBvhTriangleMeshShape> walls_;
    btSphereShape sphere_{1};
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

} // namespace

bool hasBullet()
{
    return true;
}

PeerResult runBullet(const PeerTask& task, double step)
{
    return runRigidBodies<BulletWorld>(task, step);
}

} // namespace frostfill
