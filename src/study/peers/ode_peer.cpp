// SPDX-License-Identifier: MIT
#include "simulation/contact/contact.hpp"
#include "study/peers/rigid_body_run.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

// As it comes: its headers do not hold to our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <ode/ode.h>
#pragma GCC diagnostic pop

#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <type_traits>

namespace frostfill
{
namespace
{

// The solver is as it comes: 20 sweeps a step, and a fifth of each overlap is corrected in a step.
// With four fifths a thousand spheres in the cube are not at rest after 400 sqrt(r/g), at steps of
// 0.12 and 0.06; with a fifth they are after 66 and 58.
constexpr auto kOdeBounceSpeed = static_cast<dReal>(Restitution().bounceSpeed); ///< [sqrt(g r)]
/// Overlap that is left uncorrected, so that what touches keeps touching: the manual's value. With
/// none the thousand spheres take until 109 at the longer step, and until 54 at the shorter one.
constexpr auto kOdeLayer = static_cast<dReal>(0.001); ///< [r]
/// Of one sphere and the mesh. In a corner of a cube three walls meet, with six triangles each.
constexpr std::size_t kOdeMaxContacts = 32;

/// Without this ODE would end the program.
[[noreturn]] void throwOdeError(int number, const char* format, std::va_list values)
{
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), format, values);
    throw Error(ErrorCode::postcondition, fmt::format("ODE failed ({}): {}", number, text.data()));
}

/// What is to be there before anything else of ODE, and after it.
class OdeLibrary
{
public:
    OdeLibrary()
    {
        if (dInitODE2(0) == 0)
        {
            throw Error(ErrorCode::missingProgram, "ODE cannot be initialised");
        }
        dSetErrorHandler(throwOdeError);
        dSetDebugHandler(throwOdeError);
        dRandSetSeed(0); // its solver shuffles
    }
    ~OdeLibrary()
    {
        dSetErrorHandler(nullptr);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }
    OdeLibrary(const OdeLibrary&) = delete;
    OdeLibrary& operator=(const OdeLibrary&) = delete;
};

template <auto destroy>
struct OdeDestroyer
{
    template <typename Thing>
    void operator()(Thing* thing) const
    {
        destroy(thing);
    }
};
template <typename Id, auto destroy>
using OdeOwner = std::unique_ptr<std::remove_pointer_t<Id>, OdeDestroyer<destroy>>;

/// ODE's world and spaces with all that is in them.
class OdeBodies
{
public:
    explicit OdeBodies(const PeerTask& task)
    {
        dWorldSetGravity(world_.get(), 0, -1, 0);
        dWorldSetContactSurfaceLayer(world_.get(), kOdeLayer);
        dWorldSetAutoDisableFlag(world_.get(), 0);
        surface_.mode = dContactBounce;
        surface_.mu = 0;
        surface_.bounce = static_cast<dReal>(task.restitution);
        surface_.bounce_vel = kOdeBounceSpeed;
        dMassSetSphereTotal(&mass_, 1, 1);
        addMesh(task.mesh);
    }

    void step(double dt)
    {
        dSpaceCollide(spheres_.get(), this, &touch);
        dSpaceCollide2(reinterpret_cast<dGeomID>(spheres_.get()), walls_.get(), this, &touch);
        dWorldQuickStep(world_.get(), static_cast<dReal>(dt));
        dJointGroupEmpty(contacts_.get());
    }
    [[nodiscard]] std::size_t size() const { return bodies_.size(); }
    [[nodiscard]] std::vector<Eigen::Vector3d> places() const
    {
        std::vector<Eigen::Vector3d> places;
        for (const dBodyID body : bodies_)
        {
            const dReal* p = dBodyGetPosition(body);
            places.emplace_back(p[0], p[1], p[2]);
        }
        return places;
    }

    void addSphere(const Eigen::Vector3d& place)
    {
        const dBodyID body = bodies_.emplace_back(dBodyCreate(world_.get()));
        dBodySetMass(body, &mass_);
        dBodySetPosition(body, static_cast<dReal>(place.x()), static_cast<dReal>(place.y()),
                         static_cast<dReal>(place.z()));
        dGeomSetBody(dCreateSphere(spheres_.get(), 1), body); // which the space owns
    }

private:
    /// ODE's triangles act on their front side alone: each is there twice, once from either side.
    void addMesh(const TriangleMesh& mesh)
    {
        for (const Eigen::Vector3d& v : mesh.vertices)
        {
            for (const double x : {v.x(), v.y(), v.z()})
            {
                corners_.push_back(static_cast<dReal>(x));
            }
            corners_.push_back(0); // ODE's vectors have four numbers
        }
        for (const auto& t : mesh.triangles)
        {
            triangles_.insert(triangles_.end(), {t[0], t[1], t[2], t[0], t[2], t[1]});
        }
        dGeomTriMeshDataBuildSimple(mesh_.get(), corners_.data(),
                                    static_cast<int>(mesh.vertices.size()), triangles_.data(),
                                    static_cast<int>(triangles_.size()));
        walls_.reset(dCreateTriMesh(nullptr, mesh_.get(), nullptr, nullptr, nullptr));
    }
    static void touch(void* self, dGeomID one, dGeomID other)
    {
        static_cast<OdeBodies*>(self)->addContacts(one, other);
    }
    void addContacts(dGeomID one, dGeomID other)
    {
        const int count = dCollide(one, other, static_cast<int>(found_.size()), found_.data(),
                                   sizeof(dContactGeom));
        for (int k = 0; k < count; ++k)
        {
            dContact contact{};
            contact.surface = surface_;
            contact.geom = found_[static_cast<std::size_t>(k)];
            dJointAttach(dJointCreateContact(world_.get(), contacts_.get(), &contact),
                         dGeomGetBody(one), dGeomGetBody(other));
        }
    }

    OdeLibrary library_;
    OdeOwner<dWorldID, dWorldDestroy> world_{dWorldCreate()};
    OdeOwner<dJointGroupID, dJointGroupDestroy> contacts_{dJointGroupCreate(0)};
    OdeOwner<dSpaceID, dSpaceDestroy> spheres_{dHashSpaceCreate(nullptr)};
    std::vector<dReal> corners_; // both are read by the mesh
    std::vector<dTriIndex> triangles_;
    OdeOwner<dTriMeshDataID, dGeomTriMeshDataDestroy> mesh_{dGeomTriMeshDataCreate()};
    OdeOwner<dGeomID, dGeomDestroy> walls_;
    std::vector<dBodyID> bodies_; // which the world owns
    std::array<dContactGeom, kOdeMaxContacts> found_{};
    dSurfaceParameters surface_{};
    dMass mass_{};
};

} // namespace

bool hasOde()
{
    return true;
}

PeerResult runOde(const PeerTask& task, double step)
{
    return runRigidBodies<OdeBodies>(task, step);
}

} // namespace frostfill
