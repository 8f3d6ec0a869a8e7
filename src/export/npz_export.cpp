// SPDX-License-Identifier: MIT
#include "export/npz_file.hpp"
#include "export/sphere_columns.hpp"

#include <limits>
#include <utility>

namespace frostfill
{
namespace
{

constexpr double kNotThereYet = 255; ///< as a state

constexpr const char* kTypes[] = {"|u1", "<u4", "<f4", "<f8"};

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
        }
        file_.write(centres.bytes());
        for (const PolygonState polygon : state.polygons)
        {
            polygons_.raw(static_cast<std::uint8_t>(polygon));
        }
        times_.raw(state.time);
        steps_.raw(static_cast<std::int64_t>(state.step));
        numbers_.raw(static_cast<std::int64_t>(frame.number));
        addColumns(frame);
    }
    void finish() override
    {
        file_.end();
        const std::size_t frames = run_.numbers.size();
        for (auto& [column, values] : arrays_)
        {
            array(column->plural.c_str(), typeName(*column, kTypes),
                  isFixed(*column) ? std::vector{run_.spheres} : std::vector{frames, run_.spheres},
                  values);
        }
        array("polygons", "|u1", {frames, run_.mesh.triangles.size()}, polygons_);
        array("times", "<f8", {frames}, times_);
        array("steps", "<i8", {frames}, steps_);
        array("frames", "<i8", {frames}, numbers_);
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
    /// Has one value a sphere: those of the last frame, which has them all.
    static bool isFixed(const Column& column) { return column.changes == ColumnChanges::never; }
    void addColumns(const ExportedFrame& frame)
    {
        if (arrays_.empty())
        {
            for (const Column* column : without(exportedColumns(frame.state), isCoordinate))
            {
                if (!isId(*column)) // it is the index
                {
                    arrays_.emplace_back(column, ByteWriter());
                }
            }
        }
        const bool isLast = times_.bytes().size() == run_.numbers.size() * sizeof(double);
        const std::size_t count = frame.state.states.size();
        for (auto& [column, values] : arrays_)
        {
            const double absent = column->name == "state" ? kNotThereYet : 0;
            for (std::size_t i = 0; i < run_.spheres && (isLast || !isFixed(*column)); ++i)
            {
                putBytes(values, *column,
                         i < count ? rowOf(run_, frame, i).value(*column) : absent);
            }
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
    /// [#F, #S], or [#S] where a value never changes
    std::vector<std::pair<const Column*, ByteWriter>> arrays_;
    ByteWriter polygons_;                ///< [#F, #T]
    ByteWriter times_, steps_, numbers_; ///< [#F]
};

} // namespace

std::unique_ptr<Exporter> makeNpzExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<NpzExporter>(run, folder);
}

} // namespace frostfill
