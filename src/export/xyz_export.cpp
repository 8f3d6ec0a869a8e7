// SPDX-License-Identifier: MIT
#include "export/sphere_columns.hpp"

namespace frostfill
{
namespace
{

/// Extended XYZ as ASE and OVITO read it. The species X is that of no element.
class XyzExporter : public Exporter
{
public:
    XyzExporter(const ExportedRun& run, const std::filesystem::path& folder)
        : run_(run), file_(folder / "spheres.xyz")
    {
        files_.push_back(folder / "spheres.xyz");
    }
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        const Eigen::AlignedBox3d box = boxInWorld(run_, frame);
        const Eigen::Vector3d size = box.sizes();
        const Eigen::Vector3d low = box.min();
        const ColumnList columns = without(exportedColumns(state), isCoordinate);
        std::string properties = "species:S:1:pos:R:3";
        for (const Column* column : columns)
        {
            properties += fmt::format(":{}:{}:1", column->name, column->isWhole() ? 'I' : 'R');
        }
        file_.write(
            fmt::format("{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"F F "
                        "F\" Properties={} Time={} frame={} step={}\n",
                        state.states.size(), size.x(), size.y(), size.z(), low.x(), low.y(),
                        low.z(), properties, state.time, frame.number, state.step));
        writeLines(file_, run_, frame,
                   [&](fmt::memory_buffer& row, const SphereRow& sphere)
                   {
                       fmt::format_to(std::back_inserter(row), FMT_COMPILE("X {} {} {}"),
                                      sphere.centre.x(), sphere.centre.y(), sphere.centre.z());
                       putText(row, sphere, columns, ' ');
                   });
    }
    void finish() override { file_.commit(); }

private:
    const ExportedRun& run_;
    AtomicFile file_;
};

} // namespace

std::unique_ptr<Exporter> makeXyzExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<XyzExporter>(run, folder);
}

} // namespace frostfill
