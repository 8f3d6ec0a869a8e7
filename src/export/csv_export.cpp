// SPDX-License-Identifier: MIT
#include "export/exporter.hpp"
#include "output/atomic_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace frostfill
{
namespace
{

class CsvExporter : public Exporter
{
public:
    CsvExporter(const ExportedRun& run, std::filesystem::path folder)
        : run_(run), folder_(std::move(folder))
    {
    }
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        files_.push_back(folder_ / numberedName("spheres", frame.number, "csv"));
        AtomicFile file(files_.back());
        file.write("id,x,y,z,radius,state,group,set,speed\n");
        fmt::memory_buffer row;
        for (std::size_t i = 0; i < state.states.size(); ++i)
        {
            const Eigen::Vector3d p = frame.centre(i);
            row.clear();
            fmt::format_to(std::back_inserter(row), "{},{},{},{},{},{},{},{},{}\n", i, p.x(), p.y(),
                           p.z(), frame.radii[i], static_cast<int>(state.states[i]),
                           state.groups[i], state.groups[i] / run_.groupsPerSet, state.speeds[i]);
            file.write({row.data(), row.size()});
        }
        file.commit();
    }
    void finish() override {}

private:
    const ExportedRun& run_;
    std::filesystem::path folder_;
};

} // namespace

std::unique_ptr<Exporter> makeCsvExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<CsvExporter>(run, folder);
}

} // namespace frostfill
