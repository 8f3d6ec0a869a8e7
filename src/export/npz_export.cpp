// SPDX-License-Identifier: MIT
#include "export/npz_file.hpp"
#include "export/sphere_columns.hpp"
#include "run_file/bytes.hpp"

#include <limits>

namespace frostfill
{
namespace
{

constexpr std::uint8_t kNotThereYet = 255;

/// Arrays over all frames [#F] and all spheres of the last of them [#S]. A sphere that has not yet
/// appeared has NaN for its centre.
class NpzExporter : public Exporter
{
public:
    NpzExporter(const ExportedRun& run, const std::filesystem::path& folder)
        : run_(run), file_(folder / "run.npz")
    {
        files_.push_back(folder / "run.npz");
        file_.begin("centres", "<f8", {run.numbers.size(), run.spheres, 3});
    }
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        const std::size_t count = state.states.size();
        ByteWriter centres;
        centres.bytes().reserve(run_.spheres * 3 * sizeof(double));
        for (std::size_t i = 0; i < run_.spheres; ++i)
        {
            const Eigen::Vector3d p =
                i < count ? frame.centre(i)
                          : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
            for (int axis = 0; axis < 3; ++axis)
            {
                centres.raw(p[axis]);
            }
            states_.raw(i < count ? static_cast<std::uint8_t>(state.states[i]) : kNotThereYet);
            speeds_.raw(i < count ? state.speeds[i] : 0.0F);
        }
        file_.write(centres.bytes());
        for (const PolygonState polygon : state.polygons)
        {
            polygons_.raw(static_cast<std::uint8_t>(polygon));
        }
        times_.raw(state.time);
        steps_.raw(static_cast<std::int64_t>(state.step));
        numbers_.raw(static_cast<std::int64_t>(frame.number));
        if (times_.bytes().size() == run_.numbers.size() * sizeof(double))
        {
            addSpheres(frame);
        }
    }
    void finish() override
    {
        file_.end();
        const std::size_t frames = run_.numbers.size();
        array("states", "|u1", {frames, run_.spheres}, states_);
        array("speeds", "<f4", {frames, run_.spheres}, speeds_);
        array("polygons", "|u1", {frames, run_.mesh.triangles.size()}, polygons_);
        array("times", "<f8", {frames}, times_);
        array("steps", "<i8", {frames}, steps_);
        array("frames", "<i8", {frames}, numbers_);
        array("radii", "<f8", {run_.spheres}, radii_);
        array("groups", "<u4", {run_.spheres}, groups_);
        array("sets", "<u4", {run_.spheres}, sets_);
        ByteWriter vertices;
        for (const Eigen::Vector3d& vertex : run_.mesh.vertices)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                vertices.raw(vertex[axis]);
            }
        }
        array("vertices", "<f8", {run_.mesh.vertices.size(), 3}, vertices);
        ByteWriter triangles;
        for (const auto& corners : run_.mesh.triangles)
        {
            for (const std::uint32_t corner : corners)
            {
                triangles.raw(corner);
            }
        }
        array("triangles", "<u4", {run_.mesh.triangles.size(), 3}, triangles);
        file_.commit();
    }

private:
    /// Of the last frame, which has them all.
    void addSpheres(const ExportedFrame& frame)
    {
        for (std::size_t i = 0; i < run_.spheres; ++i)
        {
            const ExportedSphere sphere = sphereOf(run_, frame, i);
            radii_.raw(sphere.radius);
            groups_.raw(sphere.group);
            sets_.raw(sphere.set);
        }
    }
    void array(const char* name, const char* type, const std::vector<std::size_t>& shape,
               ByteWriter& values)
    {
        file_.begin(name, type, shape);
        file_.write(values.bytes());
        file_.end();
    }

    const ExportedRun& run_;
    NpzFile file_;
    ByteWriter states_, speeds_, polygons_; ///< [#F, #S] or [#F, #T]
    ByteWriter times_, steps_, numbers_;    ///< [#F]
    ByteWriter radii_, groups_, sets_;      ///< [#S]
};

} // namespace

std::unique_ptr<Exporter> makeNpzExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<NpzExporter>(run, folder);
}

} // namespace frostfill
