// SPDX-License-Identifier: MIT
#include "export/sphere_columns.hpp"

namespace frostfill
{
namespace
{

/// Types are counted from 1: running, frozen, discarded.
int typeOf(const SphereRow& sphere)
{
    return static_cast<int>(sphere.state) + 1;
}

/// The text dump of LAMMPS (dump custom), which OVITO and VMD read as well. Every frame has the
/// same columns. The step of a frame is its number: LAMMPS looks frames up by it.
class DumpExporter : public Exporter
{
public:
    DumpExporter(const ExportedRun& run, const std::filesystem::path& folder)
        : run_(run), file_(folder / "spheres.dump")
    {
        files_.push_back(folder / "spheres.dump");
    }
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        const Eigen::AlignedBox3d box = boxInWorld(run_, frame);
        file_.write(fmt::format("ITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n"
                                "ITEM: BOX BOUNDS ff ff ff\n",
                                state.time, frame.number, state.states.size()));
        for (int axis = 0; axis < 3; ++axis)
        {
            file_.write(fmt::format("{} {}\n", box.min()[axis], box.max()[axis]));
        }
        const ColumnList columns = without(exportedColumns(state), isId);
        std::string heading = "ITEM: ATOMS id type";
        for (const Column* column : columns)
        {
            heading += " " + column->name;
        }
        file_.write(heading + "\n");
        writeLines(file_, run_, frame,
                   [&](fmt::memory_buffer& row, const SphereRow& sphere)
                   {
                       fmt::format_to(std::back_inserter(row), FMT_COMPILE("{} {}"), sphere.id + 1,
                                      typeOf(sphere));
                       putText(row, sphere, columns, ' ');
                   });
    }
    void finish() override { file_.commit(); }

private:
    const ExportedRun& run_;
    AtomicFile file_;
};

} // namespace

std::unique_ptr<Exporter> makeLammpsDumpExporter(const ExportedRun& run,
                                                 const std::filesystem::path& folder)
{
    return std::make_unique<DumpExporter>(run, folder);
}

} // namespace frostfill
