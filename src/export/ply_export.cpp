// SPDX-License-Identifier: MIT
#include "export/exporter.hpp"
#include "output/atomic_file.hpp"
#include "run_file/bytes.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// A PLY file whose vertices are the centres of the spheres, binary and little-endian.
class PlyExporter : public Exporter
{
public:
    PlyExporter(const ExportedRun& run, std::filesystem::path folder)
        : run_(run), folder_(std::move(folder))
    {
    }
    void add(const ExportedFrame& frame) override
    {
        const Snapshot& state = frame.state;
        ByteWriter rows;
        for (std::size_t i = 0; i < state.states.size(); ++i)
        {
            const Eigen::Vector3d p = frame.centre(i);
            rows.raw(p.x());
            rows.raw(p.y());
            rows.raw(p.z());
            rows.raw(frame.radii[i]);
            rows.raw(static_cast<std::uint32_t>(i));
            rows.raw(static_cast<std::uint8_t>(state.states[i]));
            rows.raw(state.groups[i]);
            rows.raw(state.groups[i] / run_.groupsPerSet);
            rows.raw(state.speeds[i]);
        }
        files_.push_back(folder_ / numberedName("spheres", frame.number, "ply"));
        AtomicFile file(files_.back());
        file.write(fmt::format(
            "ply\nformat binary_little_endian 1.0\ncomment frame {} at {} s\nelement vertex {}\n"
            "property double x\nproperty double y\nproperty double z\nproperty double radius\n"
            "property uint id\nproperty uchar state\nproperty uint group\nproperty uint set\n"
            "property float speed\nend_header\n",
            frame.number, state.time, state.states.size()));
        file.write(rows.bytes());
        file.commit();
    }
    void finish() override {}

private:
    const ExportedRun& run_;
    std::filesystem::path folder_;
};

} // namespace

std::unique_ptr<Exporter> makePlyExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return std::make_unique<PlyExporter>(run, folder);
}

} // namespace frostfill
