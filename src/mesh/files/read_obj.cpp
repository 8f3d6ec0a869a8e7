// SPDX-License-Identifier: MIT
#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"

namespace frostfill
{
namespace
{

/// The number of the vertex, from 0, of a corner such as "7", "7/1/2", "7//2" or "-1".
std::int64_t vertexOf(std::string_view corner, const TextScanner& scanner, std::size_t vertices)
{
    const std::int64_t index =
        scanner.toInteger(corner.substr(0, corner.find('/')), "the face's corner");
    if (index > 0)
    {
        return index - 1;
    }
    const auto known = static_cast<std::int64_t>(vertices);
    if (index == 0)
    {
        refuseAt(scanner.place(), "the face names vertex 0, but the first is vertex 1; export the "
                                  "mesh again");
    }
    if (index < -known)
    {
        refuseAt(scanner.place(),
                 fmt::format("the face names vertex {}, counted backwards, but only {} come before "
                             "it; export the mesh again",
                             index, known));
    }
    return known + index;
}

} // namespace

TriangleMesh readObj(std::string_view text)
{
    PolygonMesh mesh("line", 1);
    TextScanner scanner(text, {.comment = '#', .continues = true});
    std::vector<std::int64_t> corners;
    while (scanner.nextLine())
    {
        const std::string_view keyword = scanner.word();
        if (keyword == "v")
        {
            // What follows x, y and z is a weight, which only curves use, or a colour.
            mesh.addVertex(scanner.point("the vertex"));
        }
        else if (keyword == "f" || keyword == "fo") // fo: an old name of f
        {
            const std::uint64_t line = scanner.place().number;
            corners.clear();
            for (std::string_view corner = scanner.word(); !corner.empty(); corner = scanner.word())
            {
                corners.push_back(vertexOf(corner, scanner, mesh.vertexCount()));
            }
            mesh.addFace(line, corners);
        }
        else if (keyword == "p" || keyword == "l")
        {
            mesh.addFace(scanner.place().number, {}); // told when there is nothing else
        }
    }
    return mesh.take();
}

} // namespace frostfill
