// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "bed/bed_files.hpp"
#include "bed/bed_summary.hpp"
#include "bed/distance_field.hpp"
#include "run_file/bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace frostfill
{
namespace
{

template <class Value>
std::string_view bytesOfValues(const std::vector<Value>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

/// With the share of voxels within the container that no sphere covers.
nlohmann::ordered_json volumeSummary(const Bed& bed, const DistanceField& field)
{
    const auto outside = std::count(field.label.begin(), field.label.end(), -1);
    const auto free = std::count(field.label.begin(), field.label.end(), 0);
    const auto inside = static_cast<std::ptrdiff_t>(field.size()) - outside;
    nlohmann::ordered_json summary = bedSummary(bed);
    summary["porosity_of_voxels"] = static_cast<double>(free) / static_cast<double>(inside);
    summary["voxels"] = {field.count[0], field.count[1], field.count[2]};
    summary["origin"] = {field.origin.x(), field.origin.y(), field.origin.z()};
    summary["spacing"] = field.spacing;
    summary["label"] = "0: free, k: within sphere k - 1, -1: outside the container";
    summary["distance"] = "to the nearest sphere or wall; negative within them";
    return summary;
}

/// In NumPy's format 1.0, indexed [z, y, x]: a Python dictionary, filled up so that values begin at
/// a multiple of 64 bytes. `type` is as NumPy writes it, such as <f8.
void writeArray(const std::filesystem::path& name, const char* type, const DistanceField& field,
                std::string_view values)
{
    std::string dictionary =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}, {}), }}", type,
                    field.count[2], field.count[1], field.count[0]);
    constexpr std::size_t kBefore = 10;
    dictionary.append(63 - (kBefore + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string header("\x93NUMPY\x01\x00", 8);
    header += static_cast<char>(dictionary.size() & 0xFF); // the low byte first
    header += static_cast<char>(dictionary.size() >> 8);
    AtomicFile file(name);
    file.write(header + dictionary);
    file.write(values);
    file.commit();
}

} // namespace

void writeVti(const Bed& bed, const std::filesystem::path& folder, Files& files)
{
    const DistanceField field = sampleDistances(bed);
    const std::string extent =
        fmt::format("0 {} 0 {} 0 {}", field.count[0] - 1, field.count[1] - 1, field.count[2] - 1);
    const std::string_view distances = bytesOfValues(field.distance);
    const std::string_view labels = bytesOfValues(field.label);
    files.push_back(folder / "bed.vti");
    AtomicFile file(files.back());
    file.write(fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<ImageData WholeExtent=\"{0}\" Origin=\"{1} {2} {3}\" Spacing=\"{4} {4} {4}\">\n"
        "<Piece Extent=\"{0}\">\n<PointData Scalars=\"distance\">\n"
        "<DataArray type=\"Float32\" Name=\"distance\" format=\"appended\" offset=\"0\"/>\n"
        "<DataArray type=\"Int32\" Name=\"label\" format=\"appended\" offset=\"{5}\"/>\n"
        "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_",
        extent, field.origin.x(), field.origin.y(), field.origin.z(), field.spacing,
        distances.size() + sizeof(std::uint64_t)));
    for (const std::string_view values : {distances, labels})
    {
        ByteWriter length;
        length.raw(static_cast<std::uint64_t>(values.size()));
        file.write(length.bytes());
        file.write(values);
    }
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
    files.push_back(folder / "bed.vti.json");
    writeSummary(volumeSummary(bed, field), files.back());
}

void writeNpy(const Bed& bed, const std::filesystem::path& folder, Files& files)
{
    const DistanceField field = sampleDistances(bed);
    files.push_back(folder / "distance.npy");
    writeArray(files.back(), "<f4", field, bytesOfValues(field.distance));
    files.push_back(folder / "label.npy");
    writeArray(files.back(), "<i4", field, bytesOfValues(field.label));
    files.push_back(folder / "volume.json");
    writeSummary(volumeSummary(bed, field), files.back());
}

} // namespace frostfill
