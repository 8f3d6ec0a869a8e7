// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed_surface.hpp"

#include <filesystem>
#include <span>

namespace frostfill
{

/// Writes patches of a surface into one STL file. Binary, the attribute of a triangle is the number
/// of its patch, which OpenFOAM reads as its zone; as text each patch is a solid with its name.
void writeStl(const BedSurface& surface, std::span<const BedPatch> patches, bool ascii,
              const std::filesystem::path& name);

} // namespace frostfill
