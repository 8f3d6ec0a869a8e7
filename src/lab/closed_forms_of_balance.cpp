// SPDX-License-Identifier: MIT
#include "lab/closed_form_parts.hpp"
#include "lab/meshes.hpp"
#include "oracle/rest.hpp"
#include "oracle/rolling.hpp"
#include "simulation/quality/quality.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

/// What the judge of all spheres together says, against statics.
namespace frostfill
{
namespace
{

constexpr double kFine = 1e-3;      // of its weight that may be missing on a sphere
constexpr double kHundredth = 0.01; // of the least friction; of g
constexpr double kFloor = -7;       // centres of spheres on the floor of a hall

EquilibriumReport judged(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& centres,
                         double friction)
{
    const std::vector<double> radii(centres.size(), 1);
    const std::vector<bool> atRest(centres.size(), true);
    return examine(mesh, centres, radii, atRest, Axis::y, {friction, kFine}).equilibrium.value();
}

void addLeastFriction(ClosedFormPoints& points, const char* problem, const char* parameter,
                      double value, const TriangleMesh& mesh,
                      const std::vector<Eigen::Vector3d>& centres, double expected)
{
    const double found = judged(mesh, centres, 0).leastFriction;
    points.add(problem, "judge", parameter, value, found / expected - 1, kHundredth);
}

} // namespace

void measurePyramids(ClosedFormPoints& points)
{
    const TriangleMesh mesh = cutBoxMesh({-8, -8, -8}, {8, 8, 8});
    const std::vector<Eigen::Vector3d> onTwo = {
        {-1, kFloor, 0}, {1, kFloor, 0}, {0, kFloor + std::sqrt(3.0), 0}};
    const auto three = oracle::threeTouching(kFloor);
    std::vector<Eigen::Vector3d> onThree(three.begin(), three.end());
    onThree.emplace_back(0, kFloor + oracle::aboveThree(), 0);
    addLeastFriction(points, "pyramid stands", "spheres below", 2, mesh, onTwo,
                     oracle::frictionOfPyramid(2));
    addLeastFriction(points, "pyramid stands", "spheres below", 3, mesh, onThree,
                     oracle::frictionOfPyramid(3));
}

void measureArches(ClosedFormPoints& points)
{
    for (const double rise : {0.2, 0.4, 0.7})
    {
        const Eigen::Vector3d step = 2 * Eigen::Vector3d(std::cos(rise), -std::sin(rise), 0);
        const double half = step.x() + 1;
        const TriangleMesh mesh = cutBoxMesh({-half, -8, -8}, {half, 8, 8});
        addLeastFriction(points, "arch stands", "rise", rise * 180 / std::numbers::pi, mesh,
                         {{0, 0, 0}, step, {-step.x(), step.y(), 0}}, oracle::frictionOfArch(rise));
    }
}

// On the floor of a box that leans.
void measureRolling(ClosedFormPoints& points)
{
    for (const double angle : {0.1, 0.5, 1.0})
    {
        const Eigen::Matrix3d lean =
            Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        const TriangleMesh mesh =
            moved(cutBoxMesh({-8, -8, -8}, {8, 8, 8}), 1, lean, Eigen::Vector3d::Zero());
        const double found = judged(mesh, {lean * Eigen::Vector3d(0, kFloor, 0)}, 5).largest;
        points.add("rolls down a plane", "judge", "angle", angle * 180 / std::numbers::pi,
                   found - oracle::rollingDown(angle), kHundredth);
    }
}

} // namespace frostfill
