// SPDX-License-Identifier: MIT
// Bullet, by sequential impulses, as an engine of `frostfill-lab peers`. Without friction. Build
// it:
//     apt-get install libbullet-dev
//     c++ -O2 -o bullet bullet.cpp $(pkg-config --cflags --libs bullet)
// Then: frostfill-lab peers --peer Bullet=examples/peers/bullet
#include "peer.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>

class Bullet
{
public:
    explicit Bullet(const Task& task)
        : task_(task), world_(&dispatcher_, &broadphase_, &solver_, &configuration_)
    {
        world_.setGravity({0, -1, 0});
        world_.getSolverInfo().m_restitutionVelocityThreshold = btScalar(task.bounce);
        const auto corner = [&](unsigned vertex)
        {
            const auto& v = task.vertices[vertex];
            return btVector3(btScalar(v[0]), btScalar(v[1]), btScalar(v[2]));
        };
        for (const auto& t : task.triangles)
        {
            triangles_.addTriangle(corner(t[0]), corner(t[1]), corner(t[2]));
        }
        walls_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
        walls_->setMargin(0);
        addBody(0, walls_.get(), {0, 0, 0});
    }
    ~Bullet()
    {
        for (const auto& body : bodies_)
        {
            world_.removeRigidBody(body.get());
        }
    }

    void add(const std::array<double, 3>& p)
    {
        addBody(1, &sphere_, {btScalar(p[0]), btScalar(p[1]), btScalar(p[2])});
    }
    void step() { world_.stepSimulation(btScalar(task_.step), 0); } // exactly one of this length
    std::vector<std::array<double, 3>> places() const
    {
        std::vector<std::array<double, 3>> places;
        for (std::size_t k = 1; k < bodies_.size(); ++k) // the first is the mesh
        {
            const btVector3& p = bodies_[k]->getWorldTransform().getOrigin();
            places.push_back({p.x(), p.y(), p.z()});
        }
        return places;
    }

private:
    void addBody(btScalar mass, btCollisionShape* shape, const btVector3& place)
    {
        const btScalar inertia = mass * btScalar(0.4);
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape,
                                                      {inertia, inertia, inertia});
        info.m_startWorldTransform.setIdentity();
        info.m_startWorldTransform.setOrigin(place);
        info.m_friction = 0;
        info.m_restitution =
            btScalar(std::sqrt(task_.restitution)); // of two Bullet takes the product
        info.m_linearSleepingThreshold = btScalar(task_.still);
        info.m_angularSleepingThreshold = 1;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        world_.addRigidBody(bodies_.back().get());
    }

    Task task_;
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

int main()
{
    return servePeer<Bullet>();
}
