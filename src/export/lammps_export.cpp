// SPDX-License-Identifier: MIT
#include "export/exporter.hpp"
#include "output/atomic_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace frostfill
{
namespace
{

/// Types are counted from 1: running, frozen, discarded.
int typeOf(SphereState state)
{
    return static_cast<int>(state) + 1;
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
        file_.write("ITEM: ATOMS id type x y z radius state group set speed\n");
        fmt::memory_buffer row;
        for (std::size_t i = 0; i < state.states.size(); ++i)
        {
            const Eigen::Vector3d p = frame.centre(i);
            row.clear();
            fmt::format_to(std::back_inserter(row), "{} {} {} {} {} {} {} {} {} {}\n", i + 1,
                           typeOf(state.states[i]), p.x(), p.y(), p.z(), frame.radii[i],
                           static_cast<int>(state.states[i]), state.groups[i],
                           state.groups[i] / run_.groupsPerSet, state.speeds[i]);
            file_.write({row.data(), row.size()});
        }
    }
    void finish() override { file_.commit(); }

private:
    const ExportedRun& run_;
    AtomicFile file_;
};

/// The packing for read_data with atom_style sphere: id, type, diameter, density, x, y, z.
class DataExporter : public Exporter
{
public:
    DataExporter(const ExportedRun& run, const std::filesystem::path& folder) : run_(run)
    {
        files_.push_back(folder / "spheres.data");
    }
    /// Each frame replaces the one before: the last one stays.
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        const Eigen::AlignedBox3d box = boxInWorld(run_, frame);
        AtomicFile file(files_.front());
        file.write(fmt::format("Packing of frame {} at {} s; types 1 running, 2 frozen, 3 "
                               "discarded; density 1\n\n{} atoms\n3 atom types\n\n",
                               frame.number, state.time, state.states.size()));
        const char* axes[] = {"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis)
        {
            file.write(fmt::format("{} {} {}lo {}hi\n", box.min()[axis], box.max()[axis],
                                   axes[axis], axes[axis]));
        }
        file.write("\nAtoms # sphere\n\n");
        fmt::memory_buffer row;
        for (std::size_t i = 0; i < state.states.size(); ++i)
        {
            const Eigen::Vector3d p = frame.centre(i);
            row.clear();
            fmt::format_to(std::back_inserter(row), "{} {} {} 1 {} {} {}\n", i + 1,
                           typeOf(state.states[i]), 2 * frame.radii[i], p.x(), p.y(), p.z());
            file.write({row.data(), row.size()});
        }
        file.commit();
    }
    void finish() override {}

private:
    const ExportedRun& run_;
};

} // namespace

std::unique_ptr<Exporter> makeLammpsDumpExporter(const ExportedRun& run,
                                                 const std::filesystem::path& folder)
{
    return std::make_unique<DumpExporter>(run, folder);
}

std::unique_ptr<Exporter> makeLammpsDataExporter(const ExportedRun& run,
                                                 const std::filesystem::path& folder)
{
    return std::make_unique<DataExporter>(run, folder);
}

} // namespace frostfill
