// SPDX-License-Identifier: MIT
// ODE, by its quick step, as an engine of `frostfill-lab peers`. Without friction. Build it:
//     apt-get install libode-dev
//     c++ -O2 -o ode ode.cpp $(pkg-config --cflags --libs ode)
// Then: frostfill-lab peers --peer ODE=examples/peers/ode
#include "peer.hpp"

#include <ode/ode.h>

// The solver is as it comes: 20 sweeps a step, and a fifth of each overlap is corrected in a step.
/// Overlap that is left uncorrected, so that what touches keeps touching: the manual's value. [r]
constexpr dReal kLayer = 0.001;
/// Of one sphere and the mesh. In a corner of a cube three walls meet, with six triangles each.
constexpr int kMostContacts = 32;

class Ode
{
public:
    explicit Ode(const Task& task) : task_(task)
    {
        dInitODE2(0);
        dRandSetSeed(0); // its solver shuffles
        world_ = dWorldCreate();
        contacts_ = dJointGroupCreate(0);
        spheres_ = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world_, 0, -1, 0);
        dWorldSetContactSurfaceLayer(world_, kLayer);
        dWorldSetAutoDisableFlag(world_, 0);
        surface_.mode = dContactBounce;
        surface_.bounce = dReal(task.restitution);
        surface_.bounce_vel = dReal(task.bounce);
        dMassSetSphereTotal(&mass_, 1, 1);
        for (const auto& v : task.vertices)
        {
            corners_.insert(corners_.end(),
                            {dReal(v[0]), dReal(v[1]), dReal(v[2]), 0}); // four numbers each
        }
        // ODE's triangles act on their front side alone: each is there twice, once from either
        // side.
        for (const auto& t : task.triangles)
        {
            triangles_.insert(triangles_.end(), {t[0], t[1], t[2], t[0], t[2], t[1]});
        }
        mesh_ = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSimple(mesh_, corners_.data(), int(task.vertices.size()),
                                    triangles_.data(), int(triangles_.size()));
        walls_ = dCreateTriMesh(nullptr, mesh_, nullptr, nullptr, nullptr);
    }

    void add(const std::array<double, 3>& place)
    {
        const dBodyID body = bodies_.emplace_back(dBodyCreate(world_));
        dBodySetMass(body, &mass_);
        dBodySetPosition(body, dReal(place[0]), dReal(place[1]), dReal(place[2]));
        dGeomSetBody(dCreateSphere(spheres_, 1), body);
    }
    void step()
    {
        dSpaceCollide(spheres_, this, &touch);
        dSpaceCollide2(reinterpret_cast<dGeomID>(spheres_), walls_, this, &touch);
        dWorldQuickStep(world_, dReal(task_.step));
        dJointGroupEmpty(contacts_);
    }
    std::vector<std::array<double, 3>> places() const
    {
        std::vector<std::array<double, 3>> places;
        for (const dBodyID body : bodies_)
        {
            const dReal* p = dBodyGetPosition(body);
            places.push_back({p[0], p[1], p[2]});
        }
        return places;
    }

private:
    static void touch(void* self, dGeomID one, dGeomID other)
    {
        Ode& ode = *static_cast<Ode*>(self);
        const int count =
            dCollide(one, other, kMostContacts, ode.found_.data(), sizeof(dContactGeom));
        for (int k = 0; k < count; ++k)
        {
            dContact contact{};
            contact.surface = ode.surface_;
            contact.geom = ode.found_[std::size_t(k)];
            dJointAttach(dJointCreateContact(ode.world_, ode.contacts_, &contact),
                         dGeomGetBody(one), dGeomGetBody(other));
        }
    }

    Task task_;
    dWorldID world_ = nullptr;
    dJointGroupID contacts_ = nullptr;
    dSpaceID spheres_ = nullptr;
    std::vector<dReal> corners_; // both are read by the mesh
    std::vector<dTriIndex> triangles_;
    dTriMeshDataID mesh_ = nullptr;
    dGeomID walls_ = nullptr;
    std::vector<dBodyID> bodies_;
    std::array<dContactGeom, kMostContacts> found_{};
    dSurfaceParameters surface_{};
    dMass mass_{};
};

int main()
{
    return servePeer<Ode>();
}
