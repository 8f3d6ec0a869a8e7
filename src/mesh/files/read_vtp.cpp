// SPDX-License-Identifier: MIT
// Files of VTK in XML: VTP, and VTU if it holds a surface. Numbers as text, in base64 or raw, as
// they are or compressed by zlib.
#include "base/read_number.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"
#include "mesh/files/vtk_values.hpp"

namespace frostfill
{
namespace
{

/// The value of an attribute of a tag; empty if the tag has none.
std::string_view attribute(std::string_view tag, std::string_view name)
{
    for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1))
    {
        const std::string_view rest = tag.substr(at + name.size());
        if (at > 0 && tag[at - 1] <= ' ' && (rest.starts_with("=\"") || rest.starts_with("='")))
        {
            return rest.substr(2, rest.find(rest[1], 2) - 2);
        }
    }
    return {};
}

std::uint64_t countIn(std::string_view tag, std::string_view name)
{
    const auto number = readNumber<std::uint64_t>(attribute(tag, name));
    if (!number)
    {
        throw Unreadable(fmt::format("its {} is {}, which is no count; export the mesh again", name,
                                     quoted(attribute(tag, name))));
    }
    return *number;
}

/// Takes bytes off the front of data that are raw, or base64, of which pieces that end in = may
/// follow each other.
class ByteSource
{
public:
    ByteSource(std::string_view data, bool base64) : data_(data), base64_(base64) {}

    std::string take(std::uint64_t size)
    {
        require(size <= data_.size() + decoded_.size());
        while (base64_ && decoded_.size() < size)
        {
            decodeFour();
        }
        std::string taken(base64_ ? std::string_view(decoded_).substr(0, size)
                                  : data_.substr(0, size));
        base64_ ? void(decoded_.erase(0, size)) : data_.remove_prefix(size);
        return taken;
    }

private:
    static void require(bool holds)
    {
        if (!holds)
        {
            throw Unreadable("its data end too early or are no base64; export the mesh again");
        }
    }

    void decodeFour()
    {
        constexpr std::string_view kDigits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
        std::uint32_t bits = 0;
        unsigned digits = 0;
        for (int left = 4; left > 0; data_.remove_prefix(1))
        {
            require(!data_.empty());
            const std::size_t digit = kDigits.find(data_[0]);
            if (digit < kDigits.size())
            {
                bits = bits << 6U | static_cast<std::uint32_t>(digit & 63U);
                digits += digit < 64 ? 1 : 0;
                --left;
            }
            require(digit < kDigits.size() || data_[0] <= ' ');
        }
        require(digits >= 2);
        for (unsigned byte = 0; byte + 1 < digits; ++byte)
        {
            decoded_ += static_cast<char>(bits >> (16U - 8U * byte) & 0xffU);
        }
    }

    std::string_view data_;
    std::string decoded_;
    bool base64_;
};

class XmlVtk
{
public:
    explicit XmlVtk(std::string_view text)
    {
        std::string_view section;
        for (std::size_t at = text.find('<'); at != std::string_view::npos;)
        {
            const bool comment = text.substr(at).starts_with("<!--");
            const std::size_t end = text.find(comment ? "-->" : ">", at);
            if (end == std::string_view::npos)
            {
                throw Unreadable("it is cut off within a tag; export the mesh again");
            }
            const std::string_view tag = text.substr(at + 1, end - at - 1);
            const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/", 1));
            at = text.find('<', end);
            if (name == "VTKFile")
            {
                takeHead(tag);
            }
            else if (name == "Piece")
            {
                pieces_.push_back({tag, {}});
            }
            else if (name == "DataArray" && !pieces_.empty())
            {
                pieces_.back().arrays.push_back({section, tag, text.substr(end + 1, at - end - 1)});
            }
            else if (name == "AppendedData")
            {
                appended_ = text.substr(end + 1); // any bytes, and so no more tags
                appended_.remove_prefix(std::min(appended_.find('_'), appended_.size()));
                appendedBase64_ = attribute(tag, "encoding") == "base64";
                return;
            }
            else if (!comment && name != "/DataArray" &&
                     name.find("Information") == std::string_view::npos)
            {
                section = name;
            }
        }
    }

    [[nodiscard]] TriangleMesh read() const
    {
        PolygonMesh mesh("cell");
        for (const Piece& each : pieces_)
        {
            VtkPiece piece;
            piece.points = numbers(each, "Points", "");
            const std::uint64_t promised = countIn(each.tag, "NumberOfPoints");
            if (piece.points.size() / 3 != promised)
            {
                throw Unreadable(fmt::format("it promises {} points and holds {}; export the mesh "
                                             "again",
                                             promised, piece.points.size() / 3));
            }
            for (const std::string_view section : {"Polys", "Strips", "Cells"})
            {
                piece.cells.push_back({numbers(each, section, "connectivity"),
                                       numbers(each, section, "offsets"),
                                       section == "Polys"    ? std::vector{kVtkPolygon}
                                       : section == "Strips" ? std::vector{kVtkStrip}
                                                             : numbers(each, section, "types")});
            }
            addVtkPiece(mesh, piece);
        }
        return mesh.take();
    }

private:
    struct Array
    {
        std::string_view section, tag, content;
    };
    struct Piece
    {
        std::string_view tag;
        std::vector<Array> arrays;
    };

    void takeHead(std::string_view tag)
    {
        const std::string_view type = attribute(tag, "type");
        if (type != "PolyData" && type != "UnstructuredGrid")
        {
            throw Unreadable(fmt::format("it holds a {} of VTK, which is no surface in one file; "
                                         "save its surface as VTP (ParaView: Extract Surface)",
                                         quoted(type)));
        }
        const std::string_view compressor = attribute(tag, "compressor");
        compressed_ = !compressor.empty();
        if (compressed_ && compressor != "vtkZLibDataCompressor")
        {
            throw Unreadable(fmt::format("its numbers are compressed by {}; save it compressed by "
                                         "zlib, or not at all",
                                         quoted(compressor)));
        }
        bigEndian_ = attribute(tag, "byte_order") == "BigEndian";
        wideHeads_ = attribute(tag, "header_type") == "UInt64";
    }

    /// The array of a section; the only one for no name. Empty where there is none.
    [[nodiscard]] std::vector<double> numbers(const Piece& piece, std::string_view section,
                                              std::string_view name) const
    {
        const auto array = std::find_if(
            piece.arrays.begin(), piece.arrays.end(),
            [&](const Array& a)
            { return a.section == section && (name.empty() || attribute(a.tag, "Name") == name); });
        if (array == piece.arrays.end())
        {
            return {};
        }
        const std::string_view format = attribute(array->tag, "format");
        if (format == "ascii" || format.empty())
        {
            std::string_view text = array->content;
            return vtkNumbers(text, kAllNumbers);
        }
        const bool isAppended = format == "appended";
        const std::string_view from = isAppended ? appended_ : array->content;
        const std::uint64_t offset = isAppended ? countIn(array->tag, "offset") : 0;
        // Behind the underscore.
        ByteSource source(
            from.substr(std::min<std::uint64_t>(offset + (isAppended ? 1 : 0), from.size())),
            !isAppended || appendedBase64_);
        return vtkNumbers(compressed_ ? inflated(source) : source.take(head(source)),
                          vtkType(attribute(array->tag, "type")), bigEndian_);
    }

    std::uint64_t head(ByteSource& source) const
    {
        return wideHeads_ ? loadNumber<std::uint64_t>(source.take(8).data(), bigEndian_)
                          : loadNumber<std::uint32_t>(source.take(4).data(), bigEndian_);
    }

    /// Blocks, behind their number and their sizes: of a whole one, of the last unless it is whole,
    /// and of each when it is compressed.
    [[nodiscard]] std::string inflated(ByteSource& source) const
    {
        std::vector<std::uint64_t> heads = {head(source), head(source), head(source)};
        for (std::uint64_t left = heads[0]; left > 0; --left)
        {
            heads.push_back(head(source));
        }
        std::string all;
        for (std::size_t i = 3; i < heads.size(); ++i)
        {
            const bool whole = i + 1 < heads.size() || heads[2] == 0;
            appendInflated(source.take(heads[i]), heads[whole ? 1 : 2], all);
        }
        return all;
    }

    std::vector<Piece> pieces_;
    std::string_view appended_; ///< from its underscore on
    bool appendedBase64_ = false;
    bool compressed_ = false;
    bool bigEndian_ = false;
    bool wideHeads_ = false;
};

} // namespace

TriangleMesh readVtp(std::string_view text)
{
    return XmlVtk(text).read();
}

} // namespace frostfill
