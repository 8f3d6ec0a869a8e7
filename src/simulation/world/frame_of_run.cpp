// SPDX-License-Identifier: MIT
#include "simulation/world/frame_of_run.hpp"

#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{

FrameOfRun::FrameOfRun(const Scene& scene, const Eigen::AlignedBox3d& box, double radius)
    : origin(box.center()), length(radius)
{
    // Cyclic permutations keep the orientation of the triangles.
    switch (scene.object.up)
    {
    case Axis::x:
        axis = {2, 0, 1};
        break;
    case Axis::y:
        axis = {0, 1, 2};
        break;
    case Axis::z:
        axis = {1, 2, 0};
        break;
    }
    // Without gravity the unit of time is that of the Earth, so that speeds stay comparable.
    const double g = gravityInMeshUnits(scene);
    const double reference = g > 0 ? g : 9.81 * scene.object.unitsPerMetre;
    time = std::sqrt(radius / reference);
    gravity = g > 0 ? 1 : 0;
}

TriangleMesh FrameOfRun::toRun(const TriangleMesh& mesh) const
{
    TriangleMesh result = mesh;
    for (Eigen::Vector3d& vertex : result.vertices)
    {
        vertex = toRun(vertex);
    }
    return result;
}

namespace
{

/// From 0 to 1 with velocity and acceleration zero at both ends.
double smoothStep(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (10 + t * (6 * t - 15));
}

} // namespace

Eigen::Vector3d Pull::direction(const Eigen::Vector3d& p) const
{
    const Eigen::Vector3d pull = at(p, Eigen::Vector3d::Zero());
    const double strength = pull.norm();
    return strength > kWeightless ? Eigen::Vector3d(pull / strength) : Eigen::Vector3d::Zero();
}

ObjectMotion::ObjectMotion(const MoveSettings& settings, const FrameOfRun& frame, double height)
    : gravity_(frame.gravity), tilt_(settings.tilt * std::numbers::pi / 180),
      turn_(settings.turn * std::numbers::pi / 180), shake_(settings.shake / frame.length)
{
    if (!settings.any())
    {
        return;
    }
    duration_ =
        settings.duration ? *settings.duration / frame.time : kFalls * std::sqrt(2 * height);
    difference_ = kDifference * duration_ * kRamp;
    if (shake_ > 0)
    {
        circular_ = settings.frequency ? 2 * std::numbers::pi * *settings.frequency * frame.time
                                       : std::sqrt(kShareOfGravity / shake_);
        difference_ = std::min(difference_, kDifference / circular_);
    }
}

Eigen::Isometry3d ObjectMotion::poseAt(double time) const
{
    if (duration_ == 0)
    {
        return Eigen::Isometry3d::Identity();
    }
    const double share = time / duration_;
    const double done = smoothStep(share);
    const double swing = smoothStep(share / kRamp) * smoothStep((1 - share) / kRamp);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate(Eigen::Vector3d(shake_ * swing * std::sin(circular_ * time), 0, 0));
    pose.rotate(Eigen::AngleAxisd(turn_ * done, Eigen::Vector3d::UnitY()));
    pose.rotate(Eigen::AngleAxisd(-tilt_ * done, Eigen::Vector3d::UnitZ()));
    return pose;
}

// R^T dR/dt is the cross product with the angular velocity in the object's frame.
Eigen::Vector3d ObjectMotion::spinAt(double time) const
{
    const Eigen::Matrix3d change =
        (poseAt(time + difference_).linear() - poseAt(time - difference_).linear()) /
        (2 * difference_);
    const Eigen::Matrix3d cross = poseAt(time).linear().transpose() * change;
    return {(cross(2, 1) - cross(1, 2)) / 2, (cross(0, 2) - cross(2, 0)) / 2,
            (cross(1, 0) - cross(0, 1)) / 2};
}

Pull ObjectMotion::pullAt(double time) const
{
    Pull pull;
    pull.uniform = {0, -gravity_, 0};
    if (duration_ == 0)
    {
        return pull;
    }
    const Eigen::Isometry3d pose = poseAt(time);
    const bool over = time >= duration_;
    if (!over && shake_ > 0)
    {
        pull.uniform -= (poseAt(time + difference_).translation() - 2 * pose.translation() +
                         poseAt(time - difference_).translation()) /
                        (difference_ * difference_);
    }
    pull.uniform = pose.linear().transpose() * pull.uniform;
    pull.turns = !over && (tilt_ != 0 || turn_ != 0);
    if (pull.turns)
    {
        pull.spin = spinAt(time);
        pull.spinUp = (spinAt(time + difference_) - spinAt(time - difference_)) / (2 * difference_);
    }
    return pull;
}

} // namespace frostfill
