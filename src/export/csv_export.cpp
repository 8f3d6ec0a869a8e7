// SPDX-License-Identifier: MIT
#include "export/sphere_columns.hpp"

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
        files_.push_back(folder_ / numberedName("spheres", frame.number, "csv"));
        AtomicFile file(files_.back());
        const ColumnList columns = without(exportedColumns(frame.state), isId);
        std::string heading = "id";
        for (const Column* column : columns)
        {
            heading += "," + column->name;
        }
        file.write(heading + "\n");
        writeLines(file, run_, frame,
                   [&](fmt::memory_buffer& row, const SphereRow& sphere)
                   {
                       fmt::format_to(std::back_inserter(row), FMT_COMPILE("{}"), sphere.id);
                       putText(row, sphere, columns, ',');
                   });
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
