// SPDX-License-Identifier: MIT
#include "export/polydata_file.hpp"
#include "export/sphere_columns.hpp"

#include <optional>
#include <vector>

namespace frostfill
{
namespace
{

/// Spheres are points with arrays; each point is a vertex cell too, so that it is drawn.
void writeSpheres(const ExportedRun& run, const ExportedFrame& frame,
                  const std::filesystem::path& name)
{
    const Snapshot& state = frame.state;
    const std::size_t count = state.states.size();
    PolyDataFile file(state.time, {.points = count, .verts = count});
    file.open("Points");
    file.array(
        "Float64", "Points", count * 3 * sizeof(double),
        [&](ByteWriter& data)
        {
            for (std::size_t i = 0; i < count; ++i)
            {
                const Eigen::Vector3d p = frame.centre(i);
                data.raw(p.x());
                data.raw(p.y());
                data.raw(p.z());
            }
        },
        3);
    file.close("Points");
    file.open("PointData Scalars=\"state\"");
    for (const Column* column : without(exportedColumns(state), isCoordinate))
    {
        file.array(typeName(*column, kVtkTypes), column->name.c_str(), count * bytesOf(*column),
                   [&](ByteWriter& data)
                   {
                       for (std::size_t i = 0; i < count; ++i)
                       {
                           putBytes(data, *column, rowOf(run, frame, i).value(*column));
                       }
                   });
    }
    file.close("PointData");
    file.open("Verts");
    const auto ascending = [&](const char* label, std::int64_t first)
    {
        file.array("Int64", label, count * sizeof(std::int64_t),
                   [&](ByteWriter& data)
                   {
                       for (std::size_t i = 0; i < count; ++i)
                       {
                           data.raw(first + static_cast<std::int64_t>(i));
                       }
                   });
    };
    ascending("connectivity", 0);
    ascending("offsets", 1);
    file.close("Verts");
    file.commit(name);
}

void writeMesh(const ExportedFrame& frame, const TriangleMesh& mesh,
               const std::filesystem::path& name)
{
    const std::size_t triangles = mesh.triangles.size();
    PolyDataFile file(frame.state.time, {.points = mesh.vertices.size(), .polys = triangles});
    file.open("Points");
    file.array(
        "Float64", "Points", mesh.vertices.size() * 3 * sizeof(double),
        [&](ByteWriter& data)
        {
            for (const Eigen::Vector3d& vertex : mesh.vertices)
            {
                const Eigen::Vector3d p = frame.inWorld(vertex);
                data.raw(p.x());
                data.raw(p.y());
                data.raw(p.z());
            }
        },
        3);
    file.close("Points");
    file.open("CellData Scalars=\"state\"");
    file.array("UInt8", "state", triangles,
               [&](ByteWriter& data)
               {
                   for (const PolygonState state : frame.state.polygons)
                   {
                       data.raw(static_cast<std::uint8_t>(state));
                   }
               });
    file.close("CellData");
    file.open("Polys");
    file.array("Int64", "connectivity", triangles * 3 * sizeof(std::int64_t),
               [&](ByteWriter& data)
               {
                   for (const auto& corners : mesh.triangles)
                   {
                       for (const std::uint32_t corner : corners)
                       {
                           data.raw(static_cast<std::int64_t>(corner));
                       }
                   }
               });
    file.array("Int64", "offsets", triangles * sizeof(std::int64_t),
               [&](ByteWriter& data)
               {
                   for (std::size_t t = 0; t < triangles; ++t)
                   {
                       data.raw(static_cast<std::int64_t>(3 * (t + 1)));
                   }
               });
    file.close("Polys");
    file.commit(name);
}

class VtpExporter : public Exporter
{
public:
    VtpExporter(const ExportedRun& run, std::filesystem::path folder)
        : run_(run), folder_(std::move(folder))
    {
        files_.push_back(folder_ / "run.pvd");
    }
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        const std::string spheres = numberedName("spheres", frame.number, "vtp");
        files_.push_back(folder_ / spheres);
        writeSpheres(run_, frame, files_.back());
        // A mesh that neither moved nor changed is not written again.
        if (!drawn_ || state.polygons != drawn_->polygons ||
            state.pose.rotation != drawn_->pose.rotation ||
            state.pose.offset != drawn_->pose.offset)
        {
            mesh_ = numberedName("mesh", frame.number, "vtp");
            files_.push_back(folder_ / mesh_);
            writeMesh(frame, run_.mesh, files_.back());
            drawn_ = {state.polygons, state.pose};
        }
        entries_ += fmt::format("<DataSet timestep=\"{0}\" part=\"0\" file=\"{1}\"/>\n"
                                "<DataSet timestep=\"{0}\" part=\"1\" file=\"{2}\"/>\n",
                                state.time, spheres, mesh_);
    }
    void finish() override
    {
        AtomicFile file(files_.front());
        file.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                   "byte_order=\"LittleEndian\">\n<Collection>\n");
        file.write(entries_);
        file.write("</Collection>\n</VTKFile>\n");
        file.commit();
    }

private:
    struct Drawn
    {
        std::vector<PolygonState> polygons;
        Pose pose;
    };
    const ExportedRun& run_;
    std::filesystem::path folder_;
    std::string mesh_; ///< newest file
    std::optional<Drawn> drawn_;
    std::string entries_;
};

} // namespace

std::unique_ptr<Exporter> makeVtpExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<VtpExporter>(run, folder);
}

} // namespace frostfill
