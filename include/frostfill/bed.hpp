// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What becomes of the places where spheres touch one another or a wall, which no mesh of a flow
/// can fill.
enum class ContactTreatment : std::uint8_t
{
    none,   ///< spheres as they are
    shrink, ///< all radii are multiplied
    caps,   ///< spheres are flattened where they are near, so that a gap is left
};

/// How a packing becomes geometry: a surface, a case for OpenFOAM, volumes of values.
struct BedSettings
{
    ContactTreatment contacts = ContactTreatment::shrink;
    double factor = 0.99; ///< of radii, by `shrink`
    /// [smaller radius] between spheres, and between a sphere and a wall: what is nearer gets
    /// `caps`, which leave such a gap.
    double gap = 0.02;
    /// Parts of an edge of the icosahedron that spheres are made of: they have 20 N^2 triangles.
    std::size_t resolution = 4;
    bool ascii = false;       ///< STL as text with named solids
    std::size_t voxels = 128; ///< of volumes, along the longest side of the box
    /// [mean diameter] edge of the cells of OpenFOAM's first mesh, which is refined at spheres.
    double cell = 0.25;
    int threads = 0; ///< 0: one for each core; no bit depends on it
};

/// Reads none, shrink[:FACTOR] or caps[:GAP] into the settings. Throws Error usage.
void parseContacts(const std::string& text, BedSettings& settings);

/// Throws Error usage for what makes no sense.
void checkBedSettings(const BedSettings& settings);

} // namespace frostfill
#pragma GCC visibility pop
