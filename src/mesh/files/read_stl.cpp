// SPDX-License-Identifier: MIT
#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

// Of a binary file. [byte]
constexpr std::size_t kHead = 84; // 80 of anything, and the number of triangles
constexpr std::size_t kEach = 50; // a triangle: normal, three corners, two of anything
constexpr std::size_t kNormal = 12;

/// What a binary file says that it holds.
std::uint64_t promisedTriangles(std::string_view bytes)
{
    return loadNumber<std::uint32_t>(bytes.data() + kHead - 4, false);
}

bool isKeyword(std::string_view word, std::string_view keyword)
{
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](char a, char b)
                      { return (a >= 'A' && a <= 'Z' ? a + ('a' - 'A') : a) == b; });
}

double takeNumber(TextScanner& scanner)
{
    return scanner.toNumber(scanner.wordAnywhere(), "the vertex");
}

/// The corners of one facet after the other.
class Facets
{
public:
    void addCorner(const std::array<double, 3>& position)
    {
        corners_.push_back(static_cast<std::int64_t>(mesh_.vertexCount()));
        mesh_.addVertex(position);
    }

    [[nodiscard]] bool isOpen() const { return !corners_.empty(); }

    void close(const Place& place)
    {
        if (corners_.size() < 3)
        {
            refuseAt(place, fmt::format("a facet has {} of 3 vertices; export the mesh again",
                                        corners_.size()));
        }
        mesh_.addFace(place.number, corners_);
        corners_.clear();
        ++solids_.back().triangles;
        ++facets_;
    }

    void beginSolid(std::string_view name) { solids_.push_back({std::string(name), 0}); }

    TriangleMesh take(std::vector<MeshPatch>& solids)
    {
        TriangleMesh mesh = mesh_.take();
        solids = std::move(solids_);
        if (mesh.triangles.size() != facets_)
        {
            solids.clear();
        }
        return mesh;
    }

private:
    PolygonMesh mesh_{"line"};
    std::vector<std::int64_t> corners_;
    std::vector<MeshPatch> solids_;
    std::size_t facets_ = 0;
};

} // namespace

TriangleMesh readAsciiStl(std::string_view text, std::vector<MeshPatch>& solids)
{
    Facets facets;
    TextScanner scanner(text);
    bool isInSolid = false;
    for (std::string_view word = scanner.wordAnywhere(); !word.empty();
         word = scanner.wordAnywhere())
    {
        if (!isInSolid && !isKeyword(word, "solid"))
        {
            refuseAt(scanner.place(), fmt::format("{} stands where 'solid' should; export the mesh "
                                                  "again",
                                                  quoted(word)));
        }
        if (!isInSolid)
        {
            facets.beginSolid(scanner.word());
        }
        if (!isInSolid || isKeyword(word, "endsolid"))
        {
            scanner.skipLine(); // what is left of its name
            isInSolid = !isInSolid;
        }
        else if (isKeyword(word, "vertex"))
        {
            facets.addCorner({takeNumber(scanner), takeNumber(scanner), takeNumber(scanner)});
            continue;
        }
        const bool ends = isKeyword(word, "endloop") || isKeyword(word, "facet") ||
                          isKeyword(word, "endfacet") || isKeyword(word, "endsolid");
        if (ends && facets.isOpen())
        {
            facets.close(scanner.place());
        }
    }
    if (isInSolid)
    {
        refuseAt(scanner.place(), "the file ends before its 'endsolid'; it is cut off: export the "
                                  "mesh again");
    }
    return facets.take(solids);
}

bool hasSizeOfBinaryStl(std::string_view bytes)
{
    return bytes.size() > kHead && (bytes.size() - kHead) % kEach == 0 &&
           (bytes.size() - kHead) / kEach == promisedTriangles(bytes);
}

TriangleMesh readBinaryStl(std::string_view bytes)
{
    if (bytes.size() < kHead)
    {
        throw Unreadable("it is no STL, neither text, which begins with 'solid', nor binary, which "
                         "has a head of 84 bytes; export the mesh again");
    }
    const std::uint64_t count = promisedTriangles(bytes);
    if (count > (bytes.size() - kHead) / kEach)
    {
        refuseCount({"byte", kHead - 4}, count, "triangles of 50 bytes", bytes.size() - kHead);
    }
    PolygonMesh mesh("byte");
    mesh.reserve(3 * count, count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
        const std::size_t begin = kHead + kEach * i;
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            std::array<double, 3> position{};
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                const std::size_t at = begin + kNormal + 12 * corner + 4 * axis;
                position[axis] = loadNumber<float>(bytes.data() + at, false);
                refuseNotFinite(position[axis], {"byte", at});
            }
            mesh.addVertex(position);
        }
        const auto first = static_cast<std::int64_t>(3 * i);
        mesh.addFace(begin, std::array{first, first + 1, first + 2});
    }
    return mesh.take();
}

} // namespace frostfill
