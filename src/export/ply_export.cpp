// SPDX-License-Identifier: MIT
#include "export/sphere_columns.hpp"

namespace frostfill
{
namespace
{

constexpr const char* kPlyTypes[] = {"uchar", "uint", "float", "double"};

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
        const std::size_t count = frame.state.states.size();
        std::string head =
            fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {} at {} "
                        "s\nelement vertex {}\n",
                        frame.number, frame.state.time, count);
        const ColumnList columns = exportedColumns(frame.state);
        std::size_t bytes = 0;
        for (const Column* column : columns)
        {
            head += fmt::format("property {} {}\n", typeName(*column, kPlyTypes), column->name);
            bytes += bytesOf(*column);
        }
        ByteWriter rows;
        rows.bytes().reserve(count * bytes);
        for (std::size_t i = 0; i < count; ++i)
        {
            const SphereRow sphere = rowOf(run_, frame, i);
            for (const Column* column : columns)
            {
                putBytes(rows, *column, sphere.value(*column));
            }
        }
        files_.push_back(folder_ / numberedName("spheres", frame.number, "ply"));
        AtomicFile file(files_.back());
        file.write(head + "end_header\n");
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
