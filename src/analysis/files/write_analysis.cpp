// SPDX-License-Identifier: MIT
#include "analysis/files/analysis_points.hpp"
#include "analysis/sphere_values.hpp"
#include "base/atomic_file.hpp"
#include "base/threads.hpp"
#include "output/column_text.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace frostfill
{
namespace
{

/// Width of the bins of shares from 0 to 1: local packing fractions, and Q6.
constexpr double kShareBin = 0.01;

/// Rows that one thread writes in one go, and such parts that wait to go to the file.
constexpr std::size_t kRowsInPart = 4096;
constexpr std::size_t kPartsAtOnce = 64;

/// A folder that gets the tables of an analysis.
class Tables
{
public:
    Tables(const std::filesystem::path& folder, int threads) : folder_(folder), threads_(threads) {}

    /// Writes count rows; put(row, k) appends one, on any thread.
    template <class Put>
    void table(const std::string& name, std::string_view head, std::size_t count, Put&& put)
    {
        AtomicFile file(folder_ / name);
        file.write(fmt::format("{}\n", head));
        std::vector<fmt::memory_buffer> parts(kPartsAtOnce);
        for (std::size_t begin = 0; begin < count; begin += kRowsInPart * kPartsAtOnce)
        {
            const std::size_t rows = std::min(count - begin, kRowsInPart * kPartsAtOnce);
            forEachPart(threads_, rows, kRowsInPart,
                        [&](std::size_t first, std::size_t end, std::size_t part)
                        {
                            fmt::memory_buffer& text = parts[part];
                            text.clear();
                            for (std::size_t k = first; k < end; ++k)
                            {
                                put(text, begin + k);
                                text.push_back('\n');
                            }
                        });
            for (std::size_t part = 0; part * kRowsInPart < rows; ++part)
            {
                file.write({parts[part].data(), parts[part].size()});
            }
        }
        file.commit();
        names_.push_back(name);
    }
    /// The file of a name that is to be written otherwise.
    std::filesystem::path add(const std::string& name)
    {
        names_.push_back(name);
        return folder_ / name;
    }
    [[nodiscard]] std::vector<std::string>& names() { return names_; }
    [[nodiscard]] Threads& threads() { return threads_; }

private:
    std::filesystem::path folder_;
    Threads threads_;
    std::vector<std::string> names_;
};

/// Appends numbers with a comma between them.
template <class... Numbers>
void put(fmt::memory_buffer& row, const Numbers&... numbers)
{
    const char* separator = "";
    ((fmt::format_to(std::back_inserter(row), FMT_COMPILE("{}{}"), std::exchange(separator, ","),
                     numbers)),
     ...);
}

void writePorosity(Tables& tables, const PorosityProfiles& profiles)
{
    const std::pair<const char*, const std::vector<PorosityBin>*> all[] = {
        {"porosity_height.csv", &profiles.height},
        {"porosity_radial.csv", &profiles.radial},
        {"porosity_wall.csv", &profiles.wall}};
    for (const auto& [name, bins] : all)
    {
        tables.table(name, "from,to,porosity,error,object_volume", bins->size(),
                     [&, rows = bins](fmt::memory_buffer& row, std::size_t k)
                     {
                         const PorosityBin& bin = (*rows)[k];
                         put(row, bin.from, bin.to, bin.porosity, bin.error, bin.objectVolume);
                     });
    }
}

void writeSizes(Tables& tables, const SizeProfiles& sizes)
{
    const std::pair<const char*, const std::vector<SizeBin>*> all[] = {
        {"sizes_height.csv", &sizes.height}, {"sizes_radial.csv", &sizes.radial}};
    for (const auto& [name, bins] : all)
    {
        tables.table(name, "from,to,spheres,mean_radius,deviation", bins->size(),
                     [&, rows = bins](fmt::memory_buffer& row, std::size_t k)
                     {
                         const SizeBin& bin = (*rows)[k];
                         put(row, bin.from, bin.to, bin.spheres, bin.meanRadius, bin.deviation);
                     });
    }
}

void writeContacts(Tables& tables, const PackingAnalysis& analysis)
{
    const ContactStatistics& contacts = *analysis.contacts;
    const auto most = *std::max_element(contacts.spheres.begin(), contacts.spheres.end());
    std::vector<std::size_t> all(most + 1, 0);
    std::vector<std::size_t> rattlers(most + 1, 0);
    for (std::size_t k = 0; k < contacts.spheres.size(); ++k)
    {
        ++all[contacts.spheres[k]];
        rattlers[contacts.spheres[k]] += contacts.rattler[k];
    }
    tables.table("contacts.csv", "contacts,spheres,rattlers", all.size(),
                 [&](fmt::memory_buffer& row, std::size_t k) { put(row, k, all[k], rattlers[k]); });
    const bool hasForces = analysis.settings.forces.has_value();
    tables.table("network.csv",
                 fmt::format("first,second,gap{}", hasForces ? ",force_x,force_y,force_z" : ""),
                 contacts.network.size(),
                 [&](fmt::memory_buffer& row, std::size_t k)
                 {
                     const SphereContact& contact = contacts.network[k];
                     put(row, analysis.ids[contact.first], analysis.ids[contact.second],
                         contact.gap);
                     if (hasForces)
                     {
                         row.push_back(',');
                         put(row, contact.force.x(), contact.force.y(), contact.force.z());
                     }
                 });
}

/// How many values are in each bin; those that are no numbers are in none.
void writeShares(Tables& tables, const std::string& name, const char* counted,
                 const std::vector<double>& values)
{
    std::map<std::size_t, std::size_t> counts;
    for (const double value : values)
    {
        if (std::isfinite(value))
        {
            ++counts[static_cast<std::size_t>(value / kShareBin)];
        }
    }
    const std::vector<std::pair<std::size_t, std::size_t>> rows(counts.begin(), counts.end());
    tables.table(name, fmt::format("from,to,{}", counted), rows.size(),
                 [&](fmt::memory_buffer& row, std::size_t k)
                 {
                     const auto bin = static_cast<double>(rows[k].first);
                     put(row, bin * kShareBin, (bin + 1) * kShareBin, rows[k].second);
                 });
}

void writeSpheres(Tables& tables, const PackingAnalysis& analysis)
{
    const std::vector<SphereValue> values = sphereValues(analysis);
    std::string head;
    for (const SphereValue& value : values)
    {
        head += (head.empty() ? "" : ",") + value.column.name;
    }
    tables.table("spheres.csv", head, analysis.ids.size(),
                 [&](fmt::memory_buffer& row, std::size_t k)
                 {
                     const char* separator = "";
                     for (const SphereValue& value : values)
                     {
                         row.append(std::string_view(std::exchange(separator, ",")));
                         putText(row, value.column, value.of(k));
                     }
                 });
}

/// The files for ParaView, which are written at once.
void writePoints(Tables& tables, const PackingAnalysis& analysis)
{
    using Write = void (*)(const PackingAnalysis&, const std::filesystem::path&);
    std::vector<std::pair<Write, std::filesystem::path>> files = {
        {writeSpheresVtp, tables.add("spheres.vtp")}};
    if (analysis.contacts)
    {
        files.emplace_back(writeNetworkVtp, tables.add("network.vtp"));
    }
    tables.threads().forEachLarge(files.size(), [&](std::size_t k)
                                  { files[k].first(analysis, files[k].second); });
}

} // namespace

void refuseToReplaceAnalysis(const std::filesystem::path& folder, const char* instead)
{
    const std::filesystem::path summary = folder / "summary.json";
    if (std::filesystem::exists(std::filesystem::symlink_status(summary)))
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("'{}' is there already; {}", summary.string(), instead));
    }
}

std::vector<std::string> writeAnalysis(const PackingAnalysis& analysis,
                                       const std::filesystem::path& folder)
{
    createDirectory(folder);
    Tables tables(folder, analysis.settings.threads);
    if (analysis.porosity)
    {
        writePorosity(tables, *analysis.porosity);
    }
    if (analysis.pairs)
    {
        tables.table("pairs.csv", "from,to,g,neighbours", analysis.pairs->bins.size(),
                     [&](fmt::memory_buffer& row, std::size_t k)
                     {
                         const PairBin& bin = analysis.pairs->bins[k];
                         put(row, bin.from, bin.to, bin.g, bin.neighbours);
                     });
    }
    if (analysis.contacts)
    {
        writeContacts(tables, analysis);
    }
    if (analysis.cells)
    {
        writeShares(tables, "cells.csv", "cells", analysis.cells->fractions);
    }
    if (analysis.order)
    {
        writeShares(tables, "order.csv", "spheres", analysis.order->q6);
    }
    if (analysis.sizes)
    {
        writeSizes(tables, *analysis.sizes);
    }
    writeSpheres(tables, analysis);
    writePoints(tables, analysis);
    AtomicFile summary(tables.add("summary.json"));
    summary.write(analysisSummary(analysis));
    summary.commit();
    return std::move(tables.names());
}

} // namespace frostfill
