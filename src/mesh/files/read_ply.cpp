// SPDX-License-Identifier: MIT
#include "mesh/files/polygon_mesh.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace frostfill
{
namespace
{

enum class PlyFormat
{
    ascii,
    littleEndian,
    bigEndian
};

struct PlyProperty
{
    std::string_view name;
    const NumberType* type = nullptr;
    bool isList = false;
    const NumberType* countType = nullptr; ///< of a list
};

struct PlyElement
{
    std::string_view name;
    std::uint64_t count = 0;
    std::uint64_t line = 0; ///< where it is promised
    std::vector<PlyProperty> properties;
};

/// Names point into the text.
struct PlyHeader
{
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyAt = 0;     ///< [byte] where the data begin
    std::uint64_t bodyLine = 0; ///< the line in which they begin
};

const NumberType* takeType(TextScanner& scanner)
{
    const std::string_view word = scanner.word();
    const NumberType* type = findNumberType(word);
    if (type == nullptr)
    {
        refuseAt(scanner.place(), fmt::format("{} is no type of PLY (char, uchar, short, ushort, "
                                              "int, uint, float, double); export the mesh again",
                                              quoted(word)));
    }
    return type;
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
        if (!property.countType->isWhole)
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

// The two ways in which the body of a file holds its values. Both take them one after the other.

/// As words, one item of an element a line.
class AsciiPlyValues
{
public:
    AsciiPlyValues(std::string_view bytes, const PlyHeader& header)
        : scanner_(bytes.substr(header.bodyAt), {}, header.bodyLine)
    {
    }

    /// [byte] that a value takes at least: a digit, and what parts it from the next one. The very
    /// last may lack that.
    [[nodiscard]] static std::uint64_t leastSize(const NumberType* /*type*/) { return 2; }
    [[nodiscard]] std::uint64_t bytesLeft() const { return scanner_.bytesLeft() + 1; }
    [[nodiscard]] Place place() const { return scanner_.place(); }

    /// False at the end of the file.
    [[nodiscard]] bool beginItem() { return scanner_.nextLine(); }
    void endItem()
    {
        if (!scanner_.word().empty())
        {
            firstLonger_ = longer_ == 0 ? place().number : firstLonger_;
            ++longer_;
        }
    }
    /// Some writers put values into lines that their header does not name.
    void remark(std::vector<std::string>& remarks) const
    {
        if (longer_ > 0)
        {
            remarks.push_back(fmt::format(
                "ignored what {} more than the header says, the first in "
                "line {}",
                longer_ == 1 ? "1 line has" : fmt::format("{} lines have", longer_), firstLonger_));
        }
    }
    void endFile()
    {
        if (scanner_.nextLine())
        {
            refuseAt(place(), "the file has more data than its header says; export the mesh again");
        }
    }

    double takeCoordinate(const NumberType* /*type*/)
    {
        return scanner_.toNumber(scanner_.word(), "the line");
    }
    std::int64_t takeInteger(const NumberType* /*type*/)
    {
        return scanner_.toInteger(scanner_.word(), "the line");
    }
    void skip(const NumberType* /*type*/, std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count; ++i)
        {
            if (scanner_.word().empty())
            {
                refuseAt(place(), "the line has too few values; export the mesh again");
            }
        }
    }

private:
    TextScanner scanner_;
    std::uint64_t longer_ = 0; ///< lines with more values than properties
    std::uint64_t firstLonger_ = 0;
};

/// As bytes, without gaps.
class BinaryPlyValues
{
public:
    BinaryPlyValues(std::string_view bytes, const PlyHeader& header)
        : bytes_(bytes), at_(header.bodyAt), bigEndian_(header.format == PlyFormat::bigEndian)
    {
    }

    [[nodiscard]] static std::uint64_t leastSize(const NumberType* type) { return type->size; }
    [[nodiscard]] std::uint64_t bytesLeft() const { return bytes_.size() - at_; }
    [[nodiscard]] Place place() const { return {"byte", at_}; }

    [[nodiscard]] bool beginItem() const { return at_ < bytes_.size(); }
    void endItem() const {}
    void endFile() const {} // some writers pad
    void remark(std::vector<std::string>& /*remarks*/) const {}

    double takeCoordinate(const NumberType* type)
    {
        const Place where = place();
        const double value = take(type);
        refuseNotFinite(value, where);
        return value;
    }
    std::int64_t takeInteger(const NumberType* type)
    {
        const Place where = place();
        const double value = take(type);
        if (!(std::trunc(value) == value && std::abs(value) < 0x1p62))
        {
            refuseAt(where, "an index is not a whole number; export the mesh again");
        }
        return static_cast<std::int64_t>(value);
    }
    void skip(const NumberType* type, std::uint64_t count)
    {
        if (count > bytesLeft() / type->size)
        {
            refuseCutOff();
        }
        at_ += count * type->size;
    }

private:
    double take(const NumberType* type)
    {
        if (bytesLeft() < type->size)
        {
            refuseCutOff();
        }
        at_ += type->size;
        return type->load(bytes_.data() + at_ - type->size, bigEndian_);
    }

    [[noreturn]] void refuseCutOff() const
    {
        refuseAt(place(), "the file ends in the middle of its data; it is cut off: export the mesh "
                          "again");
    }

    std::string_view bytes_;
    std::size_t at_;
    bool bigEndian_;
};

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
