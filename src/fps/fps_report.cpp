// SPDX-License-Identifier: MIT
#include "fps/fps_report.hpp"

#include "fps/paper_numbers.hpp"

#include <frostfill/measure.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr const char* kNotSeparate = "–"; // not measured apart, or not drawn

std::string ms(double value)
{
    return fmt::format("{:.4f}", value);
}

std::string withInterval(const RepeatedMean& value)
{
    return fmt::format("{:.4f} ± {:.4f}", value.mean, value.halfWidth);
}

std::string rate(double framesPerSecond)
{
    if (framesPerSecond <= 0)
    {
        return kNotSeparate;
    }
    return fmt::format("{:.{}f}", framesPerSecond, framesPerSecond < 100 ? 1 : 0);
}

std::string percent(std::size_t part, std::size_t whole)
{
    return whole == 0 ? kNotSeparate
                      : fmt::format("{:.1f}",
                                    100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

std::vector<FpsMethod> methodsWithPlaces(const FpsResult& result)
{
    std::vector<FpsMethod> methods;
    for (const FpsMethod method : result.request.methods)
    {
        if (method != FpsMethod::fast)
        {
            methods.push_back(method);
        }
    }
    return methods;
}

const FpsMethodResult* find(const FpsObject& object, FpsMethod method)
{
    for (const FpsMethodResult& result : object.methods)
    {
        if (result.method == method)
        {
            return &result;
        }
    }
    return nullptr;
}

Table paperTable(const FpsResult& result)
{
    Table table;
    table.title = "Sphere–polygon work in ms a frame, by the place of a set between two freezings: "
                  "the paper's (on its machine, plain loop) and ours";
    table.words = 2;
    table.headings = {"object", "set", "running", "paper"};
    const auto methods = methodsWithPlaces(result);
    for (const FpsMethod method : methods)
    {
        table.headings.emplace_back(methodName(method));
    }
    for (const FpsObject& object : result.objects)
    {
        const PaperNumbers* paper = paperNumbers(object.scene.object.mesh);
        const FpsMethodResult* first = methods.empty() ? nullptr : find(object, methods.front());
        for (std::size_t i = 0; first && i < first->places.size(); ++i)
        {
            std::vector<std::string> row = {object.scene.name, fmt::format("{}.", i + 1),
                                            fmt::format("{}", first->places[i].running)};
            row.push_back(paper && i < paper->spherePolygonMs.size()
                              ? rangeText(paper->spherePolygonMs[i])
                              : kNotSeparate);
            for (const FpsMethod method : methods)
            {
                row.push_back(withInterval(find(object, method)->places[i].spherePolygon));
            }
            table.rows.push_back(row);
        }
    }
    return table;
}

Table runTable(const FpsResult& result)
{
    Table table;
    table.title = "Whole runs: ms a frame (sph-pol sphere–polygon, sph-sph sphere–sphere, all of "
                  "the simulation), then frames a second";
    table.words = 2;
    table.headings = {"object", "search", "sph-pol", "median",   "p95",       "p99", "sph-sph",
                      "all",    "p99",    "alone",   "+drawing", "+readback", "+PNG"};
    for (const FpsObject& object : result.objects)
    {
        for (const FpsMethodResult& method : object.methods)
        {
            const bool apart = method.method != FpsMethod::fast;
            const auto orDash = [&](const std::string& text)
            { return apart ? text : kNotSeparate; };
            const FpsPictures* pictures = object.picturesOf(method.method);
            const FramesPerSecond fps =
                framesPerSecond(method.stepMean.mean, pictures ? &pictures->mean : nullptr);
            table.rows.push_back(
                {object.scene.name, methodName(method.method),
                 orDash(withInterval(method.spherePolygonMean)),
                 orDash(ms(method.spherePolygon.median)), orDash(ms(method.spherePolygon.p95)),
                 orDash(ms(method.spherePolygon.p99)), orDash(ms(method.sphereSphereMean.mean)),
                 withInterval(method.stepMean), ms(method.step.p99), rate(fps.simulation),
                 rate(fps.drawing), rate(fps.readback), rate(fps.png)});
        }
    }
    return table;
}

Table pictureTable(const FpsResult& result)
{
    Table table;
    table.title = "What a picture takes in ms, when every frame is drawn: spheres and legend with "
                  "one sample a pixel, with all samples, with the shell too (drawing); then "
                  "readback and PNG; all of the drawing and readback with OSMesa, and how far "
                  "its pictures are apart (rms of 255)";
    table.words = 2;
    table.headings = {"object",   "method", "pixels",   "samples", "running", "spheres",
                      "+samples", "+shell", "readback", "PNG",     "OSMesa",  "apart"};
    for (const FpsObject& object : result.objects)
    {
        for (const FpsMethod method : {FpsMethod::grid, FpsMethod::fast})
        {
            const FpsPictures* pictures = object.picturesOf(method);
            if (!pictures)
            {
                continue;
            }
            const PictureMs& mean = pictures->mean;
            std::vector<std::string> row = {
                object.scene.name, method == FpsMethod::fast ? "fast" : "paper",
                fmt::format("{}×{}", object.scene.size.width, object.scene.size.height),
                fmt::format("{}", object.scene.samples), fmt::format("{:.1f}", pictures->running)};
            for (const double value :
                 {mean.spheres, mean.samples, mean.render, mean.readback, mean.encode})
            {
                row.push_back(fmt::format("{:.3f}", value));
            }
            const bool both = mean.osmesa > 0;
            row.push_back(both ? fmt::format("{:.3f}", mean.osmesa) : kNotSeparate);
            row.push_back(both ? fmt::format("{:.2f}", pictures->apart) : kNotSeparate);
            table.rows.push_back(row);
        }
    }
    return table;
}

std::vector<std::string> endRow(const FpsObject& object, const FpsMethodResult& method)
{
    const bool fast = method.method == FpsMethod::fast;
    const PaperNumbers* paper = paperNumbers(object.scene.object.mesh);
    const SphereSettings& spheres = object.scene.spheres;
    return {object.scene.name,
            fast ? "fast" : "paper",
            fmt::format("{}", object.triangles),
            fmt::format("{}", spheres.groupSize),
            fmt::format("{}", spheres.groupsPerSet),
            fast ? "one by one" : fmt::format("{} sets", object.scene.freezing.everySets),
            fmt::format("{}", object.spheres),
            fmt::format("{}", method.frozen),
            fmt::format("{}", method.discarded),
            percent(method.discardedPolygons, object.triangles),
            paper && !fast ? fmt::format("{:g}", paper->polygonsDiscarded) : kNotSeparate};
}

Table endTable(const FpsResult& result)
{
    Table table;
    table.title = "What was run, and what became of it: spheres at the end, discarded polygons in "
                  "per cent, ours and the paper's";
    table.words = 2;
    table.headings = {"object",  "method", "triangles", "γ",          "k",      "freezes",
                      "spheres", "frozen", "discarded", "polygons %", "paper's"};
    for (const FpsObject& object : result.objects)
    {
        // The paper's method ends in the same state whatever its search.
        const FpsMethodResult& first = object.methods.front();
        table.rows.push_back(endRow(object, first));
        const FpsMethodResult* fast = find(object, FpsMethod::fast);
        if (fast && fast != &first)
        {
            table.rows.push_back(endRow(object, *fast));
        }
    }
    return table;
}

void addDistribution(std::vector<std::string>& row, const Distribution& values)
{
    for (const double value : {values.mean, values.median, values.p95, values.p99})
    {
        row.push_back(fmt::format("{:.6g}", value));
    }
}

} // namespace

std::vector<Table> fpsTables(const FpsResult& result)
{
    std::vector<Table> tables = {paperTable(result), runTable(result), pictureTable(result),
                                 endTable(result)};
    std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
    return tables;
}

Table fpsSetTable(const FpsResult& result)
{
    Table table;
    table.headings = {"object",  "search", "set",       "place",
                      "running", "frozen", "discarded", "polygons_discarded_percent"};
    for (const char* stage : {"sphere_polygon", "sphere_sphere", "step"})
    {
        for (const char* what : {"mean", "median", "p95", "p99"})
        {
            table.headings.push_back(fmt::format("{}_{}_ms", stage, what));
        }
    }
    for (const char* what : {"render_ms", "readback_ms", "png_ms", "osmesa_ms", "fps_simulation",
                             "fps_drawing", "fps_readback", "fps_png"})
    {
        table.headings.emplace_back(what);
    }
    for (const FpsObject& object : result.objects)
    {
        for (const FpsMethodResult& method : object.methods)
        {
            for (const FpsSet& set : method.sets)
            {
                const FpsPictures* pictures = object.picturesOf(method.method);
                const PictureMs picture = !pictures ? PictureMs{}
                                          : set.set < pictures->sets.size()
                                              ? pictures->sets[set.set]
                                              : pictures->mean;
                const FramesPerSecond fps =
                    framesPerSecond(set.step.mean, pictures ? &picture : nullptr);
                std::vector<std::string> row = {
                    object.scene.name,
                    methodName(method.method),
                    fmt::format("{}", set.set),
                    fmt::format("{}", set.place),
                    fmt::format("{}", set.running),
                    fmt::format("{}", set.frozen),
                    fmt::format("{}", set.discarded),
                    fmt::format("{:.4g}", 100.0 * static_cast<double>(set.discardedPolygons) /
                                              static_cast<double>(object.triangles))};
                addDistribution(row, set.spherePolygon);
                addDistribution(row, set.sphereSphere);
                addDistribution(row, set.step);
                for (const double value :
                     {picture.render, picture.readback, picture.encode, picture.osmesa,
                      fps.simulation, fps.drawing, fps.readback, fps.png})
                {
                    row.push_back(fmt::format("{:.6g}", value));
                }
                table.rows.push_back(row);
            }
        }
    }
    return table;
}

std::string fpsCircumstances(const FpsResult& result)
{
    const MachineInfo machine = describeMachine();
    std::string text =
        fmt::format("{}, {} cores, {:.0f} GiB; {}, {}; {}\n", machine.cpu, machine.cores,
                    machine.memoryGib, machine.compiler, machine.build,
                    result.renderer.empty() ? "nothing drawn" : result.renderer);
    text += fmt::format("{} runs each, the first {} frames of each left out; ± is half a 95 % "
                        "confidence interval of the runs' means; a frame is one time step\n",
                        result.request.repeats, result.request.warmUpSteps);
    text += fmt::format("{}: the paper has no number, or the part is not measured by itself\n",
                        kNotSeparate);
    for (const FpsObject& object : result.objects)
    {
        for (const FpsPictures* pictures : {&object.paperPictures, &object.fastPictures})
        {
            if (!pictures->withoutOsmesa.empty())
            {
                return text + fmt::format("OSMesa is not measured: {}\n", pictures->withoutOsmesa);
            }
        }
    }
    return text;
}

} // namespace frostfill
