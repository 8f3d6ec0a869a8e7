// SPDX-License-Identifier: MIT
#pragma once

#include "fps/table.hpp"

#include <string>
#include <vector>

namespace frostfill
{

/// Errors below this are rounding, where lengths and gravity are about 1.
inline constexpr double kClosedFormRounding = 1e-11;

/// An error against a closed form, at one step or one fineness of the mesh.
struct ClosedFormPoint
{
    std::string problem;
    std::string method;
    std::string parameter; ///< what is varied: "step" [sqrt(r/g)], "triangles", "segments"
    double value = 0;
    double error = 0;    ///< signed; in the problem's own unit
    double expected = 0; ///< that the theory predicts, where it does; else the largest allowed
    bool exact = false;  ///< `expected` is a prediction, to be met to rounding
    /// Whether the error is as predicted, or no larger than allowed.
    [[nodiscard]] bool holds() const;
};

/// Free fall, throw, bounce, bounces to rest, head-on pair, incline, bowl, groove, cone, corner and
/// three spheres, by the integrators and steps that there are; and what the judge says of pyramids,
/// arches and a sphere that rolls.
[[nodiscard]] std::vector<ClosedFormPoint> measureClosedForms(bool quick);

[[nodiscard]] Table closedFormsCsv(const std::vector<ClosedFormPoint>& points);

} // namespace frostfill
