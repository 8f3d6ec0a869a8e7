// SPDX-License-Identifier: MIT
#include "mesh/files/vtk_values.hpp"

#include "mesh/files/binary_numbers.hpp"
#include "mesh/files/text_scanner.hpp"

#include <charconv>

namespace frostfill
{
namespace
{

template <typename Number>
double loadAsDouble(const char* from, bool bigEndian)
{
    return static_cast<double>(loadNumber<Number>(from, bigEndian));
}

template <typename Number>
constexpr VtkType typeOf(std::string_view word, std::string_view name)
{
    return {word, name, sizeof(Number), &loadAsDouble<Number>};
}

constexpr std::array<VtkType, 13> kVtkTypes = {{
    typeOf<float>("float", "Float32"),
    typeOf<double>("double", "Float64"),
    typeOf<std::int8_t>("char", "Int8"),
    typeOf<std::uint8_t>("unsigned_char", "UInt8"),
    typeOf<std::int16_t>("short", "Int16"),
    typeOf<std::uint16_t>("unsigned_short", "UInt16"),
    typeOf<std::int32_t>("int", "Int32"),
    typeOf<std::uint32_t>("unsigned_int", "UInt32"),
    typeOf<std::int64_t>("vtktypeint64", "Int64"),
    typeOf<std::uint64_t>("vtktypeuint64", "UInt64"),
    typeOf<std::int32_t>("vtkIdType", ""), // of 32 bits in files
    typeOf<std::int64_t>("long", ""),
    typeOf<std::uint64_t>("unsigned_long", ""),
}};

/// VTK's numbers of kinds of cells; those up to a polyline have no surface, and those from a
/// tetrahedron on a volume or curved sides.
constexpr double kPolyline = 4;
constexpr double kPixel = 8; // a rectangle whose corners do not go round
constexpr double kQuad = 9;

} // namespace

const VtkType& vtkType(std::string_view name)
{
    const auto* const found =
        std::find_if(kVtkTypes.begin(), kVtkTypes.end(),
                     [&](const VtkType& type)
                     { return !name.empty() && (type.word == name || type.name == name); });
    if (found == kVtkTypes.end())
    {
        throw Unreadable(fmt::format("its numbers have the type {}, which VTK does not have; "
                                     "export the mesh again",
                                     quoted(name)));
    }
    return *found;
}

std::vector<double> vtkNumbers(std::string_view bytes, const VtkType& type, bool bigEndian)
{
    std::vector<double> numbers(bytes.size() / type.size);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        numbers[i] = type.load(bytes.data() + i * type.size, bigEndian);
    }
    return numbers;
}

std::vector<double> vtkNumbers(std::string_view& text, std::uint64_t count)
{
    std::vector<double> numbers;
    while (numbers.size() < count)
    {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        double number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() && (count != kAllNumbers || !text.empty()))
        {
            throw Unreadable(fmt::format("its {}. number is {}; export the mesh again",
                                         numbers.size() + 1, quoted(text.substr(0, 20))));
        }
        if (error != std::errc())
        {
            break;
        }
        numbers.push_back(number);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return numbers;
}

void addVtkPiece(PolygonMesh& mesh, const VtkPiece& piece)
{
    const auto first = static_cast<std::int64_t>(mesh.vertexCount());
    const std::size_t count = piece.points.size() / 3;
    for (std::size_t i = 0; i < count; ++i)
    {
        mesh.addVertex({piece.points[3 * i], piece.points[3 * i + 1], piece.points[3 * i + 2]});
    }
    std::vector<std::int64_t> corners;
    for (const VtkPiece::Cells& cells : piece.cells)
    {
        std::size_t begin = 0;
        for (std::size_t k = 0; k < cells.ends.size(); ++k)
        {
            const Place where{"cell", k};
            const double end = cells.ends[k];
            const double type = cells.types.size() == 1  ? cells.types[0]
                                : k < cells.types.size() ? cells.types[k]
                                                         : -1;
            if (!(end >= static_cast<double>(begin)) ||
                end > static_cast<double>(cells.corners.size()) || !(type >= 0))
            {
                refuseAt(where, "its corners or its type are missing; export the mesh again");
            }
            if (type > kQuad)
            {
                refuseAt(where,
                         fmt::format("it is of VTK's type {:g}, which has a volume or curved "
                                     "sides; save the surface alone (ParaView: Extract "
                                     "Surface)",
                                     type));
            }
            corners.clear();
            for (; static_cast<double>(begin) < end; ++begin)
            {
                const double corner = cells.corners[begin];
                if (!(corner >= 0 && corner < static_cast<double>(count)))
                {
                    refuseAt(where, fmt::format("it names point {:g} of {} (numbered from 0); "
                                                "export the mesh again",
                                                corner, count));
                }
                corners.push_back(first + static_cast<std::int64_t>(corner));
            }
            if (type == kPixel && corners.size() == 4)
            {
                std::swap(corners[2], corners[3]);
            }
            if (type == kVtkStrip)
            {
                mesh.addStrips(k, corners);
            }
            else
            {
                mesh.addFace(k, type > kPolyline ? std::span<const std::int64_t>(corners)
                                                 : std::span<const std::int64_t>());
            }
        }
    }
}

} // namespace frostfill
