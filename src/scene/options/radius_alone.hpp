// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

namespace frostfill
{

/// A radius without a count asks to be filled until no sphere fits, whatever count the preset has.
/// `given`: a map from the keys that the user gave.
template <class Given>
void fillUntilFullForARadiusAlone(const Given& given, Scene& scene)
{
    if (given.contains("spheres.radius") && !given.contains("spheres.count"))
    {
        scene.spheres.count.reset();
    }
}

} // namespace frostfill
