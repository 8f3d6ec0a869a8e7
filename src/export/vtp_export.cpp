// SPDX-License-Identifier: MIT
#include "export/exporter.hpp"
#include "output/atomic_file.hpp"
#include "run_file/bytes.hpp"

#include <fmt/format.h>

#include <optional>

namespace frostfill
{
namespace
{

/// A VTK file of PolyData: the arrays are named in XML and follow it as they lie in memory.
class PolyDataFile
{
public:
    PolyDataFile(double time, std::size_t points, std::size_t verts, std::size_t polys)
    {
        xml_ = fmt::format("<?xml version=\"1.0\"?>\n"
                           "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                           "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n"
                           "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                           "format=\"ascii\">{}</DataArray>\n</FieldData>\n"
                           "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
                           "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                           time, points, verts, polys);
    }
    void open(const char* section) { xml_ += fmt::format("<{}>\n", section); }
    void close(const char* section) { xml_ += fmt::format("</{}>\n", section); }
    /// Appends an array: put(writer) writes its `count` values.
    template <typename Put>
    void array(const char* type, const char* name, std::size_t bytes, Put&& put, int components = 1)
    {
        xml_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                            "format=\"appended\" offset=\"{}\"/>\n",
                            type, name, components, data_.bytes().size());
        data_.raw(static_cast<std::uint64_t>(bytes));
        data_.bytes().reserve(data_.bytes().size() + bytes);
        put(data_);
    }
    void commit(const std::filesystem::path& name)
    {
        AtomicFile file(name);
        file.write(xml_);
        file.write("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
        file.write(data_.bytes());
        file.write("\n</AppendedData>\n</VTKFile>\n");
        file.commit();
    }

private:
    std::string xml_;
    ByteWriter data_;
};

/// Spheres are points with arrays; each point is a vertex cell too, so that it is drawn.
void writeSpheres(const ExportedFrame& frame, std::uint32_t groupsPerSet,
                  const std::filesystem::path& name)
{
    const Snapshot& state = frame.state;
    const std::size_t count = state.states.size();
    PolyDataFile file(state.time, count, count, 0);
    const auto each = [&](const char* type, const char* label, auto&& valueOf)
    {
        file.array(type, label, count * sizeof(valueOf(std::size_t{0})),
                   [&](ByteWriter& data)
                   {
                       for (std::size_t i = 0; i < count; ++i)
                       {
                           data.raw(valueOf(i));
                       }
                   });
    };
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
    each("Float64", "radius", [&](std::size_t i) { return frame.radii[i]; });
    each("UInt32", "id", [&](std::size_t i) { return static_cast<std::uint32_t>(i); });
    each("UInt8", "state",
         [&](std::size_t i) { return static_cast<std::uint8_t>(state.states[i]); });
    each("UInt32", "group", [&](std::size_t i) { return state.groups[i]; });
    each("UInt32", "set", [&](std::size_t i) { return state.groups[i] / groupsPerSet; });
    each("Float32", "speed", [&](std::size_t i) { return state.speeds[i]; });
    file.close("PointData");
    file.open("Verts");
    each("Int64", "connectivity", [](std::size_t i) { return static_cast<std::int64_t>(i); });
    each("Int64", "offsets", [](std::size_t i) { return static_cast<std::int64_t>(i + 1); });
    file.close("Verts");
    file.commit(name);
}

void writeMesh(const ExportedFrame& frame, const TriangleMesh& mesh,
               const std::filesystem::path& name)
{
    const std::size_t triangles = mesh.triangles.size();
    PolyDataFile file(frame.state.time, mesh.vertices.size(), 0, triangles);
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
        writeSpheres(frame, run_.groupsPerSet, files_.back());
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
