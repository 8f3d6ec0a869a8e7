// SPDX-License-Identifier: MIT
#include "mesh/files/ply_header.hpp"

#include "mesh/files/text_scanner.hpp"

#include <algorithm>
#include <optional>

namespace frostfill
{
namespace
{

struct TypeName
{
    std::string_view name;
    PlyType type;
};

constexpr std::array<TypeName, 20> kTypes = {{
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"int64", PlyType::int64},    {"uint64", PlyType::uint64},   {"long", PlyType::int64},
    {"ulong", PlyType::uint64},   {"float", PlyType::float32},   {"float32", PlyType::float32},
    {"double", PlyType::float64}, {"float64", PlyType::float64},
}};

PlyType takeType(TextScanner& scanner)
{
    const std::string_view word = scanner.word();
    const auto* const found = std::find_if(kTypes.begin(), kTypes.end(),
                                           [&](const TypeName& type) { return type.name == word; });
    if (found == kTypes.end())
    {
        refuseAt(scanner.place(), fmt::format("{} is no type of PLY (char, uchar, short, ushort, "
                                              "int, uint, float, double); export the mesh again",
                                              quoted(word)));
    }
    return found->type;
}

PlyFormat takeFormat(TextScanner& scanner)
{
    const std::string_view word = scanner.word();
    if (word == "ascii")
    {
        return PlyFormat::ascii;
    }
    if (word == "binary_little_endian")
    {
        return PlyFormat::littleEndian;
    }
    if (word == "binary_big_endian")
    {
        return PlyFormat::bigEndian;
    }
    refuseAt(scanner.place(), fmt::format("{} is no format of PLY (ascii, binary_little_endian or "
                                          "binary_big_endian); export the mesh again",
                                          quoted(word)));
}

PlyElement takeElement(TextScanner& scanner)
{
    PlyElement element;
    element.line = scanner.place().number;
    element.name = scanner.word();
    const std::int64_t count = scanner.toInteger(scanner.word(), "the element");
    if (count < 0)
    {
        refuseAt(scanner.place(), fmt::format("{} is no count; export the mesh again", count));
    }
    element.count = static_cast<std::uint64_t>(count);
    return element;
}

PlyProperty takeProperty(TextScanner& scanner)
{
    PlyProperty property;
    TextScanner ahead = scanner;
    if (ahead.word() == "list")
    {
        scanner = ahead;
        property.isList = true;
        property.countType = takeType(scanner);
        if (property.countType == PlyType::float32 || property.countType == PlyType::float64)
        {
            refuseAt(scanner.place(), "a list has a count that is no whole number; export the mesh "
                                      "again");
        }
    }
    property.type = takeType(scanner);
    property.name = scanner.word();
    return property;
}

/// [byte] of the end of the line at `at`, in the style of the file's first line. That tells whether
/// a line feed behind a carriage return belongs to it or to the data.
std::size_t sizeOfEndOfLine(std::string_view bytes, std::size_t at)
{
    const std::size_t first = std::min(bytes.find_first_of("\r\n"), bytes.size());
    const bool isPair = bytes.substr(first).starts_with("\r\n");
    return isPair && bytes.substr(at).starts_with("\r\n") ? 2 : 1;
}

} // namespace

std::size_t sizeOf(PlyType type)
{
    constexpr std::array<std::size_t, 10> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader readPlyHeader(std::string_view bytes)
{
    TextScanner scanner(bytes);
    PlyHeader header;
    std::optional<PlyFormat> format;
    scanner.wordAnywhere(); // "ply", by which the file was known
    while (scanner.nextLine())
    {
        const std::string_view keyword = scanner.word();
        if (keyword == "format")
        {
            format = takeFormat(scanner);
        }
        else if (keyword == "element")
        {
            header.elements.push_back(takeElement(scanner));
        }
        else if (keyword == "property" && !header.elements.empty())
        {
            header.elements.back().properties.push_back(takeProperty(scanner));
        }
        else if (keyword == "end_header" && format)
        {
            header.format = *format;
            scanner.skipLine();
            header.bodyAt =
                std::min(scanner.at() + sizeOfEndOfLine(bytes, scanner.at()), bytes.size());
            header.bodyLine = scanner.place().number + 1;
            return header;
        }
        else if (keyword == "property" || keyword == "end_header")
        {
            refuseAt(scanner.place(),
                     fmt::format("{} is not allowed there in a PLY header; export the mesh again",
                                 quoted(keyword)));
        }
        // Any other line is a comment: some programs leave the word out.
    }
    refuseAt(scanner.place(), "the header has no 'end_header'; the file is cut off or damaged: "
                              "export the mesh again");
}

} // namespace frostfill
