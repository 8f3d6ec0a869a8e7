// SPDX-License-Identifier: MIT
#include "mesh/files/ply_header.hpp"
#include "mesh/files/ply_values.hpp"
#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/readers.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr int kNoAxis = 3; // the property is no coordinate

int axisOf(const PlyProperty& property)
{
    const bool isOne = property.name.size() == 1 && !property.isList;
    return isOne && property.name[0] >= 'x' && property.name[0] <= 'z' ? property.name[0] - 'x'
                                                                       : kNoAxis;
}

bool isCornerList(const PlyProperty& property)
{
    return property.isList &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool isFaces(const PlyElement& element)
{
    return element.name == "face" || element.name == "tristrips";
}

/// Reads the body of one kind into a mesh.
template <typename Values>
class PlyBody
{
public:
    PlyBody(Values values, PolygonMesh& mesh) : values_(values), mesh_(mesh) {}

    void read(const PlyElement& element)
    {
        refuseEmptyPromise(element);
        if (element.name == "vertex")
        {
            mesh_.reserve(element.count, 0);
            readItems(element, [&](const auto& properties) { readVertex(properties); });
        }
        else if (isFaces(element))
        {
            mesh_.reserve(0, element.count);
            readItems(element, [&](const auto& properties)
                      { readFace(properties, element.name == "tristrips"); });
        }
        else
        {
            readItems(element, [&](const auto& properties) { skipItem(properties); });
        }
    }

    void end(std::vector<std::string>& remarks)
    {
        values_.endFile();
        values_.remark(remarks);
    }

private:
    /// A count beyond what the rest of the file can hold would fill the memory, or take forever.
    void refuseEmptyPromise(const PlyElement& element) const
    {
        std::uint64_t least = 0;
        for (const PlyProperty& property : element.properties)
        {
            least += Values::leastSize(property.isList ? property.countType : property.type);
        }
        if (least > 0 && element.count > values_.bytesLeft() / least)
        {
            refuseCount({"line", element.line}, element.count,
                        fmt::format("of element {}", quoted(element.name)), values_.bytesLeft());
        }
    }

    template <typename Read>
    void readItems(const PlyElement& element, Read read)
    {
        if (element.properties.empty())
        {
            return; // nothing is there to be read, however often
        }
        for (std::uint64_t item = 0; item < element.count; ++item)
        {
            if (!values_.beginItem())
            {
                refuseAt(values_.place(),
                         fmt::format("the file ends after {} of {} of element {}; it is cut off: "
                                     "export the mesh again",
                                     item, element.count, quoted(element.name)));
            }
            read(element.properties);
            values_.endItem();
        }
    }

    std::uint64_t takeCount(const PlyProperty& property)
    {
        const Place where = values_.place();
        const std::int64_t count = values_.takeInteger(property.countType);
        if (count < 0 || static_cast<std::uint64_t>(count) >
                             values_.bytesLeft() / Values::leastSize(property.type))
        {
            refuseAt(where, fmt::format("a list of {} numbers is promised, but only {} bytes "
                                        "follow; the file is cut off or damaged: export the mesh "
                                        "again",
                                        count, values_.bytesLeft()));
        }
        return static_cast<std::uint64_t>(count);
    }

    void skip(const PlyProperty& property)
    {
        values_.skip(property.type, property.isList ? takeCount(property) : 1);
    }

    void skipItem(const std::vector<PlyProperty>& properties)
    {
        for (const PlyProperty& property : properties)
        {
            skip(property);
        }
    }

    void readVertex(const std::vector<PlyProperty>& properties)
    {
        std::array<double, 3> position{};
        for (const PlyProperty& property : properties)
        {
            if (const int axis = axisOf(property); axis != kNoAxis)
            {
                position[static_cast<std::size_t>(axis)] = values_.takeCoordinate(property.type);
            }
            else
            {
                skip(property);
            }
        }
        mesh_.addVertex(position);
    }

    void readFace(const std::vector<PlyProperty>& properties, bool areStrips)
    {
        const std::uint64_t where = values_.place().number;
        for (const PlyProperty& property : properties)
        {
            if (!isCornerList(property))
            {
                skip(property);
                continue;
            }
            corners_.resize(takeCount(property));
            for (std::int64_t& corner : corners_)
            {
                corner = values_.takeInteger(property.type);
            }
            if (areStrips)
            {
                mesh_.addStrips(where, corners_);
            }
            else
            {
                mesh_.addFace(where, corners_);
            }
        }
    }

    Values values_;
    PolygonMesh& mesh_;
    std::vector<std::int64_t> corners_;
};

/// Refuses a header in which something needed is missing or there twice.
void refuseUnusable(const PlyHeader& header)
{
    std::size_t vertexElements = 0;
    for (const PlyElement& element : header.elements)
    {
        std::array<int, 4> axes{}; // the last counts what is no coordinate
        std::ptrdiff_t lists = 0;
        for (const PlyProperty& property : element.properties)
        {
            ++axes[static_cast<std::size_t>(axisOf(property))];
            lists += isCornerList(property) ? 1 : 0;
        }
        if (element.name == "vertex" &&
            (++vertexElements > 1 || std::any_of(axes.begin(), axes.begin() + kNoAxis,
                                                 [](int count) { return count != 1; })))
        {
            refuseAt({"line", element.line}, "the vertices do not have exactly one x, y and z; "
                                             "export the mesh again");
        }
        if (isFaces(element) && lists != 1)
        {
            refuseAt({"line", element.line},
                     fmt::format("the element {} has no list, or several, named vertex_indices or "
                                 "vertex_index; export the mesh again",
                                 quoted(element.name)));
        }
    }
}

template <typename Values>
TriangleMesh readBody(std::string_view bytes, const PlyHeader& header, std::string_view unit,
                      std::vector<std::string>& remarks)
{
    PolygonMesh mesh(unit);
    PlyBody<Values> body(Values(bytes, header), mesh);
    for (const PlyElement& element : header.elements)
    {
        body.read(element);
    }
    body.end(remarks);
    return mesh.take();
}

} // namespace

TriangleMesh readPly(std::string_view bytes, std::vector<std::string>& remarks)
{
    const PlyHeader header = readPlyHeader(bytes);
    refuseUnusable(header);
    return header.format == PlyFormat::ascii
               ? readBody<AsciiPlyValues>(bytes, header, "line", remarks)
               : readBody<BinaryPlyValues>(bytes, header, "byte", remarks);
}

} // namespace frostfill
