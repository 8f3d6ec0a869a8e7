// SPDX-License-Identifier: MIT
#include "lab/closed_forms.hpp"

#include "lab/closed_form_parts.hpp"
#include "lab/meshes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace frostfill
{

Scene unitScene(Preset preset, Integrator integrator)
{
    Scene scene = presetScene(preset, "torus");
    scene.spheres.radius = 1;
    scene.spheres.count = 1;
    scene.spheres.groupSize = 1;
    scene.motion.integrator = integrator;
    scene.motion.gravity = 1;
    scene.motion.restitution = 0;
    return scene;
}

std::unique_ptr<World> room(const TriangleMesh& mesh, const Scene& scene)
{
    return std::make_unique<World>(scene, mesh);
}

TriangleMesh hall(double half, double height)
{
    return cutBoxMesh({-half, -height / 2, -half}, {half, height / 2, half}, 2);
}

FreeFlight::Settings lossless(double restitution)
{
    FreeFlight::Settings settings;
    settings.restitution = {restitution, 0};
    settings.damping = 0;
    return settings;
}

std::vector<ClosedFormPoint> measureClosedForms(bool quick)
{
    ClosedFormPoints points;
    for (const double dt : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001})
    {
        measureFreeFall(points, dt);
        measureThrow(points, dt);
        measureBounce(points, dt);
        measureBounceToRest(points, dt);
        measureHeadOnPair(points, dt);
    }
    for (const int cuts : {1, 3, 10, quick ? 20 : 100})
    {
        measureIncline(points, cuts);
    }
    for (const int segments : {24, 48, 96, quick ? 96 : 192})
    {
        measureBowl(points, segments, 0.005);
    }
    measureGrooves(points);
    measureCones(points);
    measureCorner(points);
    measureThreeSpheres(points);
    measurePyramids(points);
    measureArches(points);
    measureRolling(points);
    return points.take();
}

bool ClosedFormPoint::holds() const
{
    return exact ? std::abs(error - expected) <= kClosedFormRounding * 100
                 : std::abs(error) <= std::abs(expected);
}

Table closedFormsCsv(const std::vector<ClosedFormPoint>& points)
{
    Table table;
    table.headings = {"problem", "method",    "parameter", "value",
                      "error",   "magnitude", "expected",  "holds"};
    for (const ClosedFormPoint& point : points)
    {
        table.rows.push_back({point.problem, point.method, point.parameter,
                              fmt::format("{:g}", point.value), fmt::format("{:.6e}", point.error),
                              fmt::format("{:.6e}", std::abs(point.error)),
                              fmt::format("{:.6e}", point.expected), point.holds() ? "1" : "0"});
    }
    return table;
}

} // namespace frostfill
