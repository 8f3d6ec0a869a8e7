// SPDX-License-Identifier: MIT
#include "export/exporter.hpp"
#include "output/atomic_file.hpp"

#include <fmt/format.h>

#include <iterator>

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
        file_.write(
            fmt::format("{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"F F F\" "
                        "Properties=species:S:1:pos:R:3:radius:R:1:id:I:1:state:I:1:group:I:1:set:"
                        "I:1:speed:R:1 "
                        "Time={} frame={} step={}\n",
                        state.states.size(), size.x(), size.y(), size.z(), low.x(), low.y(),
                        low.z(), state.time, frame.number, state.step));
        fmt::memory_buffer row;
        for (std::size_t i = 0; i < state.states.size(); ++i)
        {
            const Eigen::Vector3d p = frame.centre(i);
            row.clear();
            fmt::format_to(std::back_inserter(row), "X {} {} {} {} {} {} {} {} {}\n", p.x(), p.y(),
                           p.z(), frame.radii[i], i, static_cast<int>(state.states[i]),
                           state.groups[i], state.groups[i] / run_.groupsPerSet, state.speeds[i]);
            file_.write({row.data(), row.size()});
        }
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
