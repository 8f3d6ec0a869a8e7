// SPDX-License-Identifier: MIT
#include "analysis/files/analysis_points.hpp"

#include "analysis/sphere_values.hpp"
#include "export/polydata_file.hpp"
#include "export/sphere_columns.hpp"

namespace frostfill
{
namespace
{

/// vectorOf(k) is the k-th of `count`.
template <class VectorOf>
void putVectors(PolyDataFile& file, const char* name, std::size_t count, VectorOf&& vectorOf)
{
    file.array(
        "Float64", name, count * 3 * sizeof(double),
        [&](ByteWriter& data)
        {
            for (std::size_t k = 0; k < count; ++k)
            {
                const Eigen::Vector3d& vector = vectorOf(k);
                data.raw(vector.x());
                data.raw(vector.y());
                data.raw(vector.z());
            }
        },
        3);
}

void putCentres(PolyDataFile& file, const PackingAnalysis& analysis)
{
    file.open("Points");
    putVectors(
        file, "Points",
        analysis.centres.size(), [&](std::size_t k) -> auto& { return analysis.centres[k]; });
    file.close("Points");
}

/// Cells of `corners` points each; pointOf(n) is the n-th of all.
template <class PointOf>
void putCells(PolyDataFile& file, const char* section, std::size_t cells, std::size_t corners,
              PointOf&& pointOf)
{
    file.open(section);
    file.array("Int64", "connectivity", cells * corners * sizeof(std::int64_t),
               [&](ByteWriter& data)
               {
                   for (std::size_t n = 0; n < cells * corners; ++n)
                   {
                       data.raw(static_cast<std::int64_t>(pointOf(n)));
                   }
               });
    file.array("Int64", "offsets", cells * sizeof(std::int64_t),
               [&](ByteWriter& data)
               {
                   for (std::size_t cell = 1; cell <= cells; ++cell)
                   {
                       data.raw(static_cast<std::int64_t>(cell * corners));
                   }
               });
    file.close(section);
}

} // namespace

void writeSpheresVtp(const PackingAnalysis& analysis, const std::filesystem::path& file)
{
    const std::size_t count = analysis.ids.size();
    PolyDataFile points(0, {.points = count, .verts = count});
    putCentres(points, analysis);
    points.open("PointData");
    for (const SphereValue& value : sphereValues(analysis))
    {
        if (!isCoordinate(value.column))
        {
            points.array(typeName(value.column, kVtkTypes), value.column.name.c_str(),
                         count * bytesOf(value.column),
                         [&](ByteWriter& data)
                         {
                             for (std::size_t k = 0; k < count; ++k)
                             {
                                 putBytes(data, value.column, value.of(k));
                             }
                         });
        }
    }
    points.close("PointData");
    putCells(points, "Verts", count, 1, [](std::size_t n) { return n; });
    points.commit(file);
}

void writeNetworkVtp(const PackingAnalysis& analysis, const std::filesystem::path& file)
{
    const std::vector<SphereContact>& network = analysis.contacts->network;
    PolyDataFile lines(0, {.points = analysis.ids.size(), .lines = network.size()});
    putCentres(lines, analysis);
    lines.open("CellData");
    lines.array("Float64", "gap", network.size() * sizeof(double),
                [&](ByteWriter& data)
                {
                    for (const SphereContact& contact : network)
                    {
                        data.raw(contact.gap);
                    }
                });
    if (analysis.settings.forces)
    {
        putVectors(
            lines, "force",
            network.size(), [&](std::size_t k) -> auto& { return network[k].force; });
    }
    lines.close("CellData");
    putCells(lines, "Lines", network.size(), 2,
             [&](std::size_t n)
             { return n % 2 == 0 ? network[n / 2].first : network[n / 2].second; });
    lines.commit(file);
}

} // namespace frostfill
