// SPDX-License-Identifier: MIT
#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"

namespace frostfill
{
namespace
{

// What a vertex and a face take at least: "0 0 0\n" and "0\n". [byte]
constexpr std::uint64_t kMinVertex = 6;
constexpr std::uint64_t kMinFace = 2;

struct Counts
{
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

std::uint64_t takeCount(TextScanner& scanner, std::string_view word)
{
    const std::int64_t count = scanner.toInteger(word, "the head");
    if (count < 0)
    {
        refuseAt(scanner.place(), fmt::format("{} is no count; export the mesh again", count));
    }
    return static_cast<std::uint64_t>(count);
}

/// Takes the word OFF and its relatives, as far as they are there, and returns the next word.
std::string_view skipKeyword(TextScanner& scanner)
{
    const std::string_view keyword = scanner.wordAnywhere();
    if (!keyword.ends_with("OFF"))
    {
        return keyword;
    }
    const std::string_view options = keyword.substr(0, keyword.size() - 3);
    if (options.find_first_not_of("STCN") != std::string_view::npos)
    {
        refuseAt(scanner.place(),
                 fmt::format("{} has coordinates in a space of more than three dimensions, which "
                             "cannot be filled; export the mesh as plain OFF",
                             quoted(keyword)));
    }
    std::string_view next = scanner.wordAnywhere();
    if (next == "BINARY")
    {
        refuseAt(scanner.place(),
                 "binary OFF is not among the formats that can be read; export the "
                 "mesh as OFF in text, or as binary PLY or STL");
    }
    return next;
}

/// The number of edges, which is not needed and often left out, may be in the same line or alone in
/// the next one.
void skipEdgeCount(TextScanner& scanner)
{
    if (!scanner.word().empty())
    {
        return;
    }
    TextScanner ahead = scanner;
    ahead.wordAnywhere();
    if (ahead.word().empty())
    {
        scanner = ahead;
    }
}

Counts readHead(TextScanner& scanner)
{
    Counts counts;
    counts.vertices = takeCount(scanner, skipKeyword(scanner));
    counts.faces = takeCount(scanner, scanner.wordAnywhere());
    const std::uint64_t left = scanner.bytesLeft() + 1; // the last line may lack its end
    if (counts.vertices > left / kMinVertex)
    {
        refuseCount(scanner.place(), counts.vertices, "vertices", left - 1);
    }
    if (counts.faces > (left - kMinVertex * counts.vertices) / kMinFace)
    {
        refuseCount(scanner.place(), counts.faces, "faces", left - 1);
    }
    if (counts.faces > 0)
    {
        skipEdgeCount(scanner);
    }
    return counts;
}

void nextLine(TextScanner& scanner, std::uint64_t have, std::uint64_t promised,
              std::string_view what)
{
    if (!scanner.nextLine())
    {
        refuseAt(
            scanner.place(),
            fmt::format("the file ends after {} of {} {}; it is cut off: export the mesh again",
                        have, promised, what));
    }
}

} // namespace

TriangleMesh readOff(std::string_view text)
{
    TextScanner scanner(text, {.comment = '#'});
    const Counts counts = readHead(scanner);
    PolygonMesh mesh("line");
    mesh.reserve(counts.vertices, counts.faces);
    for (std::uint64_t i = 0; i < counts.vertices; ++i)
    {
        nextLine(scanner, i, counts.vertices, "vertices");
        // Normals, colours and texture coordinates follow x, y and z.
        mesh.addVertex(scanner.point("the vertex"));
    }
    std::vector<std::int64_t> corners;
    for (std::uint64_t i = 0; i < counts.faces; ++i)
    {
        nextLine(scanner, i, counts.faces, "faces");
        const Place where = scanner.place();
        const std::uint64_t size = takeCount(scanner, scanner.word());
        corners.clear();
        for (std::uint64_t corner = 0; corner < size; ++corner)
        {
            // The format is free: a face may go on in the next line. One that is cut off takes
            // numbers of the next face, and the file then ends too early.
            const std::string_view word = scanner.wordAnywhere();
            if (word.empty())
            {
                refuseAt(where, "the face has too few numbers; export the mesh again");
            }
            corners.push_back(scanner.toInteger(word, "the face"));
        }
        mesh.addFace(where.number, corners); // its colour follows
    }
    if (scanner.nextLine())
    {
        refuseAt(scanner.place(),
                 fmt::format("the file has more data after its {} faces; export the mesh again",
                             counts.faces));
    }
    return mesh.take();
}

} // namespace frostfill
