// SPDX-License-Identifier: MIT
// Legacy files of VTK, as ParaView, PyVista, meshio and OpenFOAM write them: versions 1 to 5.1; and
// what they share with those of XML.
#include "base/read_number.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"
#include "mesh/files/vtk_values.hpp"

#include <charconv>

namespace frostfill
{
namespace
{

/// VTK's numbers of kinds of cells; those up to a polyline have no surface, and those from a
/// tetrahedron on a volume or curved sides.
constexpr double kPolyline = 4;
constexpr double kPixel = 8; // a rectangle whose corners do not go round
constexpr double kQuad = 9;

} // namespace

const NumberType& vtkType(std::string_view name)
{
    const NumberType* type = findNumberType(name);
    if (type == nullptr)
    {
        throw Unreadable(fmt::format("its numbers have the type {}, which VTK does not have; "
                                     "export the mesh again",
                                     quoted(name)));
    }
    return *type;
}

std::vector<double> vtkNumbers(std::string_view bytes, const NumberType& type, bool bigEndian)
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

namespace
{

class LegacyVtk
{
public:
    explicit LegacyVtk(std::string_view bytes) : rest_(bytes), size_(bytes.size())
    {
        std::ignore = line(); // # vtk DataFile Version 5.1
        std::ignore = line(); // a title
        const std::string_view encoding = word();
        binary_ = encoding == "BINARY";
        if (!binary_ && encoding != "ASCII")
        {
            refuse(fmt::format("{} is neither ASCII nor BINARY", quoted(encoding)));
        }
    }

    VtkPiece read()
    {
        VtkPiece piece;
        for (std::string_view key = word(); !key.empty() && !key.ends_with("_DATA"); key = word())
        {
            if (key == "DATASET")
            {
                requireSurface(word());
            }
            else if (key == "POINTS")
            {
                const std::uint64_t points = count();
                piece.points = numbers(3, points, word());
            }
            else if (key == "POLYGONS" || key == "TRIANGLE_STRIPS" || key == "CELLS")
            {
                piece.cells.push_back(cells());
                piece.cells.back().types = {key == "TRIANGLE_STRIPS" ? kVtkStrip : kVtkPolygon};
            }
            else if (key == "VERTICES" || key == "LINES")
            {
                std::ignore = cells();
            }
            else if (key == "CELL_TYPES" && !piece.cells.empty())
            {
                piece.cells.back().types = numbers(1, count(), "int");
            }
            else if (key == "FIELD")
            {
                skipField();
            }
            else if (key == "METADATA")
            {
                skipMetadata();
            }
            else
            {
                refuse(fmt::format("{} is no part of a surface", quoted(key)));
            }
        }
        return piece;
    }

private:
    [[noreturn]] void refuse(const std::string& why) const
    {
        refuseAt({"byte", size_ - rest_.size()}, why + "; export the mesh again");
    }

    std::string_view line()
    {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return text;
    }

    std::string_view word()
    {
        constexpr std::string_view kBlanks = " \t\r\n";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
        const std::string_view text = rest_.substr(0, rest_.find_first_of(kBlanks));
        rest_.remove_prefix(text.size());
        return text;
    }

    std::uint64_t count()
    {
        const std::string_view text = word();
        const auto number = readNumber<std::uint64_t>(text);
        if (!number || *number > size_)
        {
            refuse(fmt::format("{} is no count that this file has room for", quoted(text)));
        }
        return *number;
    }

    void requireSurface(std::string_view dataset) const
    {
        if (dataset != "POLYDATA" && dataset != "UNSTRUCTURED_GRID")
        {
            throw Unreadable(fmt::format("it holds a {} of VTK, which has no surface of polygons; "
                                         "save its surface (ParaView: Extract Surface)",
                                         quoted(dataset)));
        }
    }

    /// Numbers that begin in the next line.
    std::vector<double> numbers(std::uint64_t each, std::uint64_t many, std::string_view typeName)
    {
        const NumberType& type = vtkType(typeName);
        if (!binary_)
        {
            return vtkNumbers(rest_, each * many);
        }
        std::ignore = line();
        const std::uint64_t bytes = each * many * type.size;
        if (each * many > rest_.size() / type.size)
        {
            refuseCount({"byte", size_ - rest_.size()}, each * many, "numbers", rest_.size());
        }
        const std::string_view taken = rest_.substr(0, bytes);
        rest_.remove_prefix(bytes);
        return vtkNumbers(taken, type, true);
    }

    /// Up to version 4, each cell has its number of corners before them; later there are two
    /// arrays.
    VtkPiece::Cells cells()
    {
        VtkPiece::Cells read;
        const std::uint64_t many = count();
        const std::uint64_t all = count();
        std::string_view ahead = rest_;
        ahead.remove_prefix(std::min(ahead.find_first_not_of(" \t\r\n"), ahead.size()));
        if (ahead.starts_with("OFFSETS"))
        {
            std::ignore = word();
            read.ends = numbers(1, many, word());
            read.ends.erase(read.ends.begin(), read.ends.begin() + (many > 0 ? 1 : 0));
            if (word() != "CONNECTIVITY")
            {
                refuse("CONNECTIVITY is missing");
            }
            read.corners = numbers(1, all, word());
            return read;
        }
        const std::vector<double> packed = numbers(1, all, "int");
        for (std::size_t at = 0; at < packed.size() && read.ends.size() < many;)
        {
            const double size = packed[at++];
            if (!(size >= 0 && size <= static_cast<double>(packed.size() - at)))
            {
                refuse(fmt::format("cell {} has {:g} corners", read.ends.size(), size));
            }
            const auto from = packed.begin() + static_cast<std::ptrdiff_t>(at);
            read.corners.insert(read.corners.end(), from, from + static_cast<std::ptrdiff_t>(size));
            read.ends.push_back(static_cast<double>(read.corners.size()));
            at += static_cast<std::size_t>(size);
        }
        return read;
    }

    void skipField()
    {
        std::ignore = word();
        for (std::uint64_t left = count(); left > 0; --left)
        {
            if (word() == "METADATA") // in place of the name: of the array before
            {
                skipMetadata();
                std::ignore = word();
            }
            const std::uint64_t each = count();
            const std::uint64_t many = count();
            std::ignore = numbers(each, many, word());
        }
    }

    void skipMetadata()
    {
        std::ignore = line();
        while (!rest_.empty() && line().find_first_not_of(" \r") != std::string_view::npos)
        {
        }
    }

    std::string_view rest_;
    std::size_t size_;
    bool binary_ = false;
};

} // namespace

TriangleMesh readVtk(std::string_view bytes)
{
    PolygonMesh mesh("cell");
    addVtkPiece(mesh, LegacyVtk(bytes).read());
    return mesh.take();
}

} // namespace frostfill
