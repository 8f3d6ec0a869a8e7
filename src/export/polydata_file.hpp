// SPDX-License-Identifier: MIT
#pragma once

#include "base/atomic_file.hpp"
#include "run_file/bytes.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// The names of types, in the order of ColumnType.
inline constexpr const char* kVtkTypes[] = {"UInt8", "UInt32", "Float32", "Float64"};

/// A VTK file of PolyData: the arrays are named in XML and follow it as they lie in memory.
class PolyDataFile
{
public:
    /// How many there are of each.
    struct Sizes
    {
        std::size_t points = 0;
        std::size_t verts = 0;
        std::size_t lines = 0;
        std::size_t polys = 0;
    };

    PolyDataFile(double time, const Sizes& sizes)
    {
        xml_ = fmt::format("<?xml version=\"1.0\"?>\n"
                           "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                           "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n"
                           "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                           "format=\"ascii\">{}</DataArray>\n</FieldData>\n"
                           "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                           "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                           time, sizes.points, sizes.verts, sizes.lines, sizes.polys);
    }
    void open(const char* section) { xml_ += fmt::format("<{}>\n", section); }
    void close(const char* section) { xml_ += fmt::format("</{}>\n", section); }
    /// Appends an array: put(writer) writes its `count` values.
    template <typename Put>
    void array(const char* type, const char* name, std::size_t bytes, Put&& put, int components = 1)
    {
        xml_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                            "format=\"appended\" offset=\"{}\"/>\n",
                            type, name, components, offset_);
        ByteWriter& data = arrays_.emplace_back();
        data.bytes().reserve(sizeof(std::uint64_t) + bytes);
        data.raw(static_cast<std::uint64_t>(bytes));
        put(data);
        offset_ += data.bytes().size();
    }
    void commit(const std::filesystem::path& name)
    {
        AtomicFile file(name);
        file.write(xml_);
        file.write("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
        for (ByteWriter& array : arrays_)
        {
            file.write(array.bytes());
        }
        file.write("\n</AppendedData>\n</VTKFile>\n");
        file.commit();
    }

private:
    std::string xml_;
    std::vector<ByteWriter> arrays_; ///< each behind its length
    std::size_t offset_ = 0;         ///< where the next one begins
};

} // namespace frostfill
