// SPDX-License-Identifier: MIT
// The two ways in which the body of a PLY file holds its values. Both take them one after the
// other.
#pragma once

#include "mesh/files/binary_numbers.hpp"
#include "mesh/files/ply_header.hpp"
#include "mesh/files/text_scanner.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace frostfill
{

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
    [[nodiscard]] static std::uint64_t leastSize(PlyType /*type*/) { return 2; }
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

    double takeCoordinate(PlyType /*type*/)
    {
        return scanner_.toNumber(scanner_.word(), "the line");
    }
    std::int64_t takeInteger(PlyType /*type*/)
    {
        return scanner_.toInteger(scanner_.word(), "the line");
    }
    void skip(PlyType /*type*/, std::uint64_t count)
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

    [[nodiscard]] static std::uint64_t leastSize(PlyType type) { return sizeOf(type); }
    [[nodiscard]] std::uint64_t bytesLeft() const { return bytes_.size() - at_; }
    [[nodiscard]] Place place() const { return {"byte", at_}; }

    [[nodiscard]] bool beginItem() const { return at_ < bytes_.size(); }
    void endItem() const {}
    void endFile() const {} // some writers pad
    void remark(std::vector<std::string>& /*remarks*/) const {}

    double takeCoordinate(PlyType type)
    {
        const Place where = place();
        const double value = take<double>(type);
        refuseNotFinite(value, where);
        return value;
    }
    std::int64_t takeInteger(PlyType type)
    {
        const Place where = place();
        if (type == PlyType::float32 || type == PlyType::float64)
        {
            const double value = takeCoordinate(type);
            const auto whole = static_cast<std::int64_t>(std::clamp(value, -1e18, 1e18));
            if (static_cast<double>(whole) != value)
            {
                refuseAt(where, "an index is not a whole number; export the mesh again");
            }
            return whole;
        }
        return take<std::int64_t>(type);
    }
    void skip(PlyType type, std::uint64_t count)
    {
        if (count > bytesLeft() / sizeOf(type))
        {
            refuseCutOff();
        }
        at_ += count * sizeOf(type);
    }

private:
    template <typename Number>
    Number load()
    {
        if (bytesLeft() < sizeof(Number))
        {
            refuseCutOff();
        }
        at_ += sizeof(Number);
        return loadNumber<Number>(bytes_.data() + at_ - sizeof(Number), bigEndian_);
    }

    template <typename Result>
    Result take(PlyType type)
    {
        switch (type)
        {
        case PlyType::int8:
            return static_cast<Result>(load<std::int8_t>());
        case PlyType::uint8:
            return static_cast<Result>(load<std::uint8_t>());
        case PlyType::int16:
            return static_cast<Result>(load<std::int16_t>());
        case PlyType::uint16:
            return static_cast<Result>(load<std::uint16_t>());
        case PlyType::int32:
            return static_cast<Result>(load<std::int32_t>());
        case PlyType::uint32:
            return static_cast<Result>(load<std::uint32_t>());
        case PlyType::int64:
            return static_cast<Result>(load<std::int64_t>());
        case PlyType::uint64:
            return static_cast<Result>(load<std::uint64_t>());
        case PlyType::float32:
            return static_cast<Result>(load<float>());
        case PlyType::float64:
            break;
        }
        return static_cast<Result>(load<double>());
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

} // namespace frostfill
