// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/files/polygon_mesh.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace frostfill
{

/// The type of that name in files of VTK. Throws Unreadable.
[[nodiscard]] const NumberType& vtkType(std::string_view name);

inline constexpr std::uint64_t kAllNumbers = ~std::uint64_t{0};

/// Read numbers as they lie in memory, or take numbers off the front of a text. A double holds all
/// of them: indices are below 2^32. Throw Unreadable for a word that is no number, or if numbers
/// are missing.
[[nodiscard]] std::vector<double> vtkNumbers(std::string_view bytes, const NumberType& type,
                                             bool bigEndian);
[[nodiscard]] std::vector<double> vtkNumbers(std::string_view& text, std::uint64_t count);

/// Points, and cells between them.
struct VtkPiece
{
    struct Cells
    {
        std::vector<double> corners; ///< of all cells, one after the other
        std::vector<double> ends;    ///< of each cell in `corners`
        std::vector<double> types;   ///< of each cell, or one of all
    };
    std::vector<double> points; ///< x, y, z of each
    std::vector<Cells> cells;
};

inline constexpr double kVtkStrip = 6;
inline constexpr double kVtkPolygon = 7;

/// Adds the surface of a piece; points and lines are left out. Throws Unreadable, also for cells
/// that have a volume.
void addVtkPiece(PolygonMesh& mesh, const VtkPiece& piece);

} // namespace frostfill
