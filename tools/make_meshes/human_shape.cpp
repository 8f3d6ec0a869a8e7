// SPDX-License-Identifier: MIT
// A human of seven and a half heads, from round cones and ellipsoids that melt into each other.
// All lengths in metres; y is up, the face looks along +z; one side is modelled, |x| gives both.
#include "surface.hpp"

#include <algorithm>
#include <cmath>

namespace
{

using Vector = Eigen::Vector3d;

/// Minimum of two fields, rounded where they are closer than `blend`.
double smoothMin(double a, double b, double blend)
{
    const double h = std::max(blend - std::abs(a - b), 0.0) / blend;
    return std::min(a, b) - 0.25 * blend * h * h;
}

/// A ball of radius `ra` at `a` growing into one of radius `rb` at `b`.
double roundCone(const Vector& p, const Vector& a, const Vector& b, double ra, double rb)
{
    const Vector axis = b - a;
    const double length = axis.norm();
    const double slope = (ra - rb) / length;
    const double along = (p - a).dot(axis) / length;
    const double across = std::sqrt(std::max((p - a).squaredNorm() - along * along, 0.0));
    const double cosine = std::sqrt(1 - slope * slope);
    const double foot = along + across * slope / cosine; // where the normal meets the axis
    if (foot <= 0)
    {
        return (p - a).norm() - ra;
    }
    if (foot >= length)
    {
        return (p - b).norm() - rb;
    }
    return along * slope + across * cosine - ra;
}

/// First-order distance to an ellipsoid along the axes.
double ellipsoid(const Vector& p, const Vector& centre, const Vector& radii)
{
    const double level = (p - centre).cwiseQuotient(radii).norm();
    const double slope = (p - centre).cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return slope > 0 ? level * (level - 1) / slope : -radii.minCoeff();
}

double head(const Vector& p)
{
    double d = ellipsoid(p, {0, 1.695, -0.005}, {0.077, 0.107, 0.097});
    d = smoothMin(d, ellipsoid(p, {0, 1.632, 0.030}, {0.056, 0.072, 0.066}), 0.05);
    d = smoothMin(d, roundCone(p, {0, 1.690, 0.090}, {0, 1.658, 0.108}, 0.009, 0.015), 0.025);
    return smoothMin(d, ellipsoid(p, {0.079, 1.672, -0.008}, {0.013, 0.033, 0.021}), 0.015);
}

double torso(const Vector& p)
{
    double d = ellipsoid(p, {0, 1.285, -0.005}, {0.160, 0.205, 0.110});
    d = smoothMin(d, ellipsoid(p, {0, 1.080, 0.005}, {0.128, 0.170, 0.096}), 0.08);
    d = smoothMin(d, ellipsoid(p, {0, 0.935, -0.005}, {0.160, 0.115, 0.108}), 0.08);
    d = smoothMin(d, ellipsoid(p, {0.072, 1.325, 0.062}, {0.078, 0.062, 0.048}), 0.05);
    d = smoothMin(d, ellipsoid(p, {0.074, 0.905, -0.060}, {0.078, 0.085, 0.070}), 0.05);
    d = smoothMin(d, roundCone(p, {0.020, 1.500, -0.025}, {0.165, 1.435, -0.015}, 0.045, 0.058),
                  0.06);
    return smoothMin(d, roundCone(p, {0, 1.430, -0.020}, {0, 1.610, 0.002}, 0.060, 0.054), 0.045);
}

double arm(const Vector& p)
{
    const Vector shoulder(0.190, 1.430, -0.012), elbow(0.352, 1.185, -0.020);
    const Vector wrist(0.492, 0.975, 0.030);
    double d = roundCone(p, shoulder, elbow, 0.063, 0.046);
    d = smoothMin(d, roundCone(p, elbow, wrist, 0.046, 0.031), 0.03);
    return smoothMin(d, ellipsoid(p, {0.392, 1.125, -0.008}, {0.052, 0.085, 0.050}), 0.05);
}

/// A mitten: palm and fingers in one, flat, and a thumb that points forward and down.
double hand(const Vector& p)
{
    const Vector wrist(0.492, 0.975, 0.030);
    const Vector along = Vector(0.50, -0.85, 0.16).normalized();
    const Vector thick = Vector(0.85, 0.50, 0.0).normalized(); // out of the back of the hand
    const Vector wide = thick.cross(along);
    const auto flat = [&](double from, double to, double ra, double rb)
    {
        // Squeezed across the hand by measuring that direction larger.
        const Vector local = p - wrist;
        const Vector squeezed(local.dot(along), local.dot(wide), 1.5 * local.dot(thick));
        return roundCone(squeezed, {from, 0, 0}, {to, 0, 0}, ra, rb) / 1.3;
    };
    double d = flat(0.040, 0.090, 0.041, 0.045);
    d = smoothMin(d, flat(0.090, 0.168, 0.043, 0.029), 0.02);
    const Vector side = wide.z() > 0 ? wide : Vector(-wide);
    const Vector root = wrist + 0.035 * along + 0.022 * side;
    const Vector middle = wrist + 0.070 * along + 0.062 * side - 0.006 * thick;
    const Vector tip = wrist + 0.108 * along + 0.072 * side - 0.012 * thick;
    d = smoothMin(d, roundCone(p, root, middle, 0.021, 0.016), 0.012);
    return smoothMin(d, roundCone(p, middle, tip, 0.016, 0.0125), 0.010);
}

double leg(const Vector& p)
{
    const Vector hip(0.092, 0.885, 0.000), knee(0.128, 0.500, 0.012), ankle(0.150, 0.085, -0.025);
    double d = roundCone(p, hip, knee, 0.087, 0.057);
    d = smoothMin(d, roundCone(p, knee, ankle, 0.053, 0.036), 0.03);
    d = smoothMin(d, ellipsoid(p, {0.138, 0.365, -0.030}, {0.053, 0.125, 0.054}), 0.05);
    return smoothMin(d, ellipsoid(p, {0.104, 0.715, 0.026}, {0.072, 0.150, 0.066}), 0.06);
}

/// Points a little outwards; the sole is cut flat at y = 0.
double foot(const Vector& p)
{
    const Vector heel(0.150, 0.036, -0.055), ball(0.178, 0.024, 0.105), toes(0.186, 0.016, 0.155);
    double d = roundCone(p, heel, ball, 0.040, 0.042);
    d = smoothMin(d, roundCone(p, ball, toes, 0.042, 0.030), 0.02);
    d = smoothMin(d, roundCone(p, {0.150, 0.090, -0.025}, {0.170, 0.045, 0.075}, 0.036, 0.030),
                  0.04);
    return -smoothMin(-d, p.y(), 0.012);
}

} // namespace

double humanField(const Eigen::Vector3d& point)
{
    const Vector p(std::abs(point.x()), point.y(), point.z());
    double d = smoothMin(torso(p), head(p), 0.03);
    d = smoothMin(d, smoothMin(arm(p), hand(p), 0.025), 0.045);
    return smoothMin(d, smoothMin(leg(p), foot(p), 0.02), 0.04);
}
