// SPDX-License-Identifier: MIT
#include "fps/fps_report.hpp"
#include "fps/paper_numbers.hpp"
#include "lab/study.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

void addRow(Table& table, std::size_t number, const std::string& object, const char* series,
            double ms, double low, double high)
{
    table.rows.push_back({fmt::format("{}", number), object, series, fmt::format("{:.6g}", ms),
                          fmt::format("{:.6g}", low), fmt::format("{:.6g}", high)});
}

/// The paper's times over its sets: middle, least and greatest; `saved` is taken off.
void addPaper(Table& table, std::size_t number, const PaperNumbers& paper, const char* series,
              const PaperRange& saved)
{
    PaperRange all = paper.spherePolygonMs.front();
    double middle = 0;
    for (const PaperRange& range : paper.spherePolygonMs)
    {
        all.low = std::min(all.low, range.low);
        all.high = std::max(all.high, range.high);
        middle += (range.low + range.high) / 2;
    }
    middle /= static_cast<double>(paper.spherePolygonMs.size());
    addRow(table, number, std::string(paper.object), series, middle - (saved.low + saved.high) / 2,
           all.low - saved.high, all.high - saved.low);
}

Table timesTable(const FpsResult& result)
{
    Table table;
    table.headings = {"number", "object", "series", "ms", "low", "high"};
    for (std::size_t i = 0; i < result.objects.size(); ++i)
    {
        const FpsObject& object = result.objects[i];
        if (const PaperNumbers* paper = paperNumbers(object.scene.object.mesh))
        {
            addPaper(table, i, *paper, "paper loop", {});
            addPaper(table, i, *paper, "paper tree", paper->treeGainMs);
        }
        // Ours: the mean over the whole run, and the places between two freezings as low and high.
        for (const FpsMethodResult& method : object.methods)
        {
            if (method.places.empty())
            {
                continue;
            }
            std::vector<double> places;
            for (const FpsPlace& place : method.places)
            {
                places.push_back(place.spherePolygon.mean);
            }
            addRow(table, i, object.scene.name, methodName(method.method),
                   method.spherePolygonMean.mean, *std::min_element(places.begin(), places.end()),
                   *std::max_element(places.begin(), places.end()));
        }
    }
    return table;
}

} // namespace

TimesTables measureTimes(bool quick, const LabProgress& progress)
{
    FpsRequest request;
    for (const std::string& name : builtInMeshNames())
    {
        request.scenes.push_back(presetScene(Preset::paper, name));
        if (quick)
        {
            request.scenes.back().spheres.count = 40;
            request.scenes.back().size = {320, 180};
        }
    }
    request.repeats = quick ? 1 : request.repeats;
    // The runs of an object are told of, and its pictures.
    const std::size_t all = request.scenes.size() * (request.repeats + 1);
    std::size_t begun = 0;
    const FpsResult result =
        measureFps(request, [&](const std::string& what) { progress(begun++, all, what); });
    std::string markdown = "# Frames a second, the paper's and ours\n\n";
    for (const Table& table : fpsTables(result))
    {
        markdown += formatMarkdown(table) + "\n";
    }
    return {timesTable(result), fpsSetTable(result), markdown + fpsCircumstances(result)};
}

} // namespace frostfill
