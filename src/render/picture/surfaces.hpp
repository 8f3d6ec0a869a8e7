// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/framing.hpp"
#include "render/picture/sphere_instance.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/snapshot.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace frostfill
{

/// What is seen of the spheres in each pixel, top row first.
struct Surfaces
{
    static constexpr float kNothing = std::numeric_limits<float>::infinity();

    int width = 0;
    int height = 0;
    std::vector<float> distance; ///< [height x width] along the view, unit space; or kNothing
    std::vector<std::array<std::uint8_t, 3>> normal; ///< 0..255 for -1..1, in eye space
    std::vector<std::uint32_t> identity;             ///< index of the sphere + 1; or 0

    /// Before set().
    void resize(const PictureSize& size);
    /// Sets a pixel; y counts from below. A normal has x in its lowest byte.
    void set(int x, int y, float inDistance, std::uint32_t withNormal, std::uint32_t ofSphere);
};

/// The spheres of a snapshot in unit space, by id. Each has its identity for a colour: the id + 1.
[[nodiscard]] std::vector<SphereInstance> placeSpheres(const Snapshot& snapshot,
                                                       const Framing& framing);

/// Surfaces in the form in which they are given out. `pictures` is reused.
void makePassPictures(const Surfaces& surfaces, const Framing& framing, PassPictures& pictures);

} // namespace frostfill
