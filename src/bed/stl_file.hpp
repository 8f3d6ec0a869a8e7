// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed_surface.hpp"

#include <filesystem>
#include <span>

namespace frostfill
{

/// Writes patches of a surface, by their places in those of its bed, into one STL file. Binary, the
/// attribute of a triangle is that place, which OpenFOAM reads as its zone; as text each patch is a
/// solid with its name.
void writeStl(const BedSurface& surface, std::span<const std::size_t> patches, bool ascii,
              const std::filesystem::path& name);

} // namespace frostfill
