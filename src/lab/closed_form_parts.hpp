// SPDX-License-Identifier: MIT
#pragma once

#include "lab/closed_forms.hpp"
#include "simulation/motion/free_flight.hpp"

#include <memory>
#include <numbers>

namespace frostfill
{

// Everything here is in units of the run: r = 1, g = 1.

/// A scene of one sphere that loses all in a bounce.
[[nodiscard]] Scene unitScene(Preset preset, Integrator integrator = Integrator::explicitEuler);

/// A room of our own: sphere and gravity have size 1, and its centre is the origin.
[[nodiscard]] std::unique_ptr<World> room(const TriangleMesh& mesh,
                                          const Scene& scene = unitScene(Preset::fast));

/// An upright box around the origin, `half` to each side.
[[nodiscard]] TriangleMesh hall(double half, double height);

/// A flight that loses nothing by itself.
[[nodiscard]] FreeFlight::Settings lossless(double restitution);

/// What is measured, in the order in which it is shown.
class ClosedFormPoints
{
public:
    /// An error that may be no larger than `allowed`.
    void add(const char* problem, const char* method, const char* parameter, double value,
             double error, double allowed)
    {
        points_.push_back({problem, method, parameter, value, error, allowed, false});
    }
    /// An error that the theory predicts.
    void addPredicted(const char* problem, const char* method, const char* parameter, double value,
                      double error, double expected)
    {
        points_.push_back({problem, method, parameter, value, error, expected, true});
    }
    [[nodiscard]] std::vector<ClosedFormPoint> take() { return std::move(points_); }

private:
    std::vector<ClosedFormPoint> points_;
};

// How spheres move: at a step [sqrt(r/g)], over a slope cut into pieces, in a bowl of segments.
void measureFreeFall(ClosedFormPoints& points, double dt);
void measureThrow(ClosedFormPoints& points, double dt);
void measureBounce(ClosedFormPoints& points, double dt);
void measureBounceToRest(ClosedFormPoints& points, double dt);
void measureHeadOnPair(ClosedFormPoints& points, double dt);
void measureIncline(ClosedFormPoints& points, int cuts);
void measureBowl(ClosedFormPoints& points, int segments, double dt);

// Where spheres come to rest.
void measureGrooves(ClosedFormPoints& points);
void measureCones(ClosedFormPoints& points);
void measureCorner(ClosedFormPoints& points);
void measureThreeSpheres(ClosedFormPoints& points);

// What all spheres together need to stand, and how one rolls.
void measurePyramids(ClosedFormPoints& points);
void measureArches(ClosedFormPoints& points);
void measureRolling(ClosedFormPoints& points);

} // namespace frostfill
