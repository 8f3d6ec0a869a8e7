// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed.hpp"

#include <filesystem>
#include <vector>

namespace frostfill
{

/// Writers of beds. Each appends what it has written to `files`, what to open comes first. They
/// throw Error cannotCreate, writeFailed, and badData as BedSurface.
using Files = std::vector<std::filesystem::path>;

/// bed.stl, binary with the number of the patch as attribute of each triangle, or as text with a
/// solid for each patch; and bed.stl.json.
void writeStlBed(const Bed& bed, const std::filesystem::path& folder, Files& files);
/// A case of OpenFOAM: a mesh of blocks, surfaces of patches, dictionaries, first fields. Lengths
/// of the bed are in metres. Returns an estimate of the cells that snappyHexMesh will make.
double writeOpenFoamCase(const Bed& bed, const std::filesystem::path& folder, Files& files);
/// bed.geo: the exact spheres and the container for gmsh's OpenCASCADE kernel; and bed.geo.json.
/// Returns an estimate of the tetrahedra that gmsh will make.
double writeGmshBed(const Bed& bed, const std::filesystem::path& folder, Files& files);
/// bed.vti: signed distance and label of each voxel, and bed.vti.json.
void writeVti(const Bed& bed, const std::filesystem::path& folder, Files& files);
/// The same as distance.npy and label.npy, and volume.json.
void writeNpy(const Bed& bed, const std::filesystem::path& folder, Files& files);

} // namespace frostfill
