// SPDX-License-Identifier: MIT
#include "run.hpp"

#include "input.hpp"
#include "interrupts.hpp"
#include "pictures.hpp"
#include "state.hpp"

#include <frostfill/export.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/picture_settings.hpp>
#include <frostfill/render_run.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <memory>

namespace py = pybind11;

namespace frostfill::python
{
namespace
{

/// A run that is kept in a file.
class KeptRun
{
public:
    explicit KeptRun(const std::filesystem::path& run)
        : file_(fileOfRun(run)), reader_(file_), scene_(sceneOfRun(reader_)),
          mesh_(std::make_shared<const TriangleMesh>(reader_.mesh()))
    {
        if (reader_.frames().empty())
        {
            throw Error(ErrorCode::badData,
                        fmt::format("'{}' has no frame yet: its run was killed as it began",
                                    file_.string()));
        }
    }

    /// The last state, which is read once.
    std::shared_ptr<State> last()
    {
        if (!last_)
        {
            last_ = seek(reader_.frames().size() - 1);
        }
        return last_;
    }

    /// The state of a frame by its number; negative numbers count from the last.
    std::shared_ptr<State> frame(std::int64_t number)
    {
        const std::vector<std::size_t>& frames = reader_.frames();
        const auto count = static_cast<std::int64_t>(frames.size());
        if (number < 0 && number >= -count)
        {
            return seek(static_cast<std::size_t>(count + number));
        }
        const auto found = number < 0 ? frames.end()
                                      : std::lower_bound(frames.begin(), frames.end(),
                                                         static_cast<std::size_t>(number));
        if (found == frames.end() || *found != static_cast<std::size_t>(number))
        {
            throw Error(ErrorCode::usage,
                        fmt::format("the run has no frame {}: it has {} frames, numbered {} to {}",
                                    number, count, frames.front(), frames.back()));
        }
        return seek(static_cast<std::size_t>(found - frames.begin()));
    }

    std::shared_ptr<State> at(std::size_t index)
    {
        if (index >= reader_.frames().size())
        {
            throw py::index_error(); // ends a loop over the run
        }
        return seek(index);
    }

    py::array render(const py::object& number, const py::kwargs& keywords)
    {
        Scene scene = scene_;
        GivenKeywords(keywords, OptionUse::pictures, "Run.render").apply(scene);
        validateScene(scene);
        const std::shared_ptr<State> state =
            number.is_none() ? last() : frame(wholeNumberOf(number, "frame"));
        scene.frames.selection = number.is_none() ? "last" : "all";
        return drawPicture(*mesh_, pictureSettings(reader_, scene), state->snapshot);
    }

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const RunFileReader& reader() const { return reader_; }
    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh() const { return mesh_; }

private:
    std::shared_ptr<State> seek(std::size_t index)
    {
        const ExclusiveUse busy(busy_);
        const py::gil_scoped_release release;
        auto state = std::make_shared<State>();
        state->snapshot = reader_.seek(index);
        state->snapshot.source = 0; // a copy, which no renderer has seen
        state->centres = reader_.centres();
        state->radii = reader_.radii();
        state->frame = reader_.frames()[index];
        return state;
    }

    std::filesystem::path file_;
    RunFileReader reader_;
    Scene scene_;
    std::shared_ptr<const TriangleMesh> mesh_;
    std::shared_ptr<State> last_;
    std::atomic<bool> busy_ = false;
};

FillRequest readFillRequest(const py::object& mesh, const py::object& vertices,
                            const py::object& triangles, const py::object& sceneFile,
                            const py::kwargs& keywords)
{
    const GivenKeywords given(keywords, OptionUse::filling, "fill");
    FillRequest request;
    if (!sceneFile.is_none())
    {
        request.scene = loadRunScene(pathOf(sceneFile, "scene"));
        if (!mesh.is_none())
        {
            request.scene.object.mesh = meshNameOf(mesh);
        }
        given.apply(request.scene);
    }
    if (sceneFile.is_none() || !vertices.is_none() || !triangles.is_none())
    {
        GivenMesh object = readGivenMesh(mesh, vertices, triangles);
        request.mesh = std::move(object.mesh);
        if (sceneFile.is_none())
        {
            request.scene = given.sceneFor(object.name);
        }
    }
    if (!given.contains("frames.which"))
    {
        request.scene.frames.enabled = false; // pictures are drawn when they are asked for
    }
    request.scene.frames.keepRun = true; // a run in Python is what the file holds
    validateScene(request.scene);
    given.warnOfIgnored(request.scene.preset);
    return request;
}

/// The share of its work that a run has done: spheres appear, come to rest, and are drawn.
double shareOf(const FillProgress& now)
{
    const auto [done, all] = now.pictures > 0
                                 ? std::pair(now.frames, now.pictures)
                                 : std::pair(now.spheres + now.resting, 2 * now.expected);
    return std::min(1.0,
                    static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(all, 1)));
}

/// Does what the command fill does. Returns what went wrong with the result, and with the video.
py::tuple fillInto(const std::filesystem::path& directory, const py::object& mesh,
                   const py::object& vertices, const py::object& triangles,
                   const py::object& sceneFile, bool overwrite, bool resume,
                   const py::object& progress, const py::kwargs& keywords)
{
    FillRequest request = readFillRequest(mesh, vertices, triangles, sceneFile, keywords);
    request.directory = directory;
    request.overwrite = overwrite;
    request.resume = resume;
    Interrupts interrupts;
    FillObserver observer;
    observer.stopRequested = interrupts.stopRequested();
    if (!progress.is_none())
    {
        observer.progressed = [&](const FillProgress& now)
        {
            interrupts.report(progress, shareOf(now), now.pictures > 0, now.settles, now.spheres,
                              now.time);
        };
    }
    FillResult result;
    {
        const py::gil_scoped_release release;
        result = fill(request, observer);
    }
    interrupts.throwIfHappened();
    return py::make_tuple(result.failure, result.videoFailure);
}

/// Does what the command render does. Returns the number of pictures.
std::size_t drawRun(const KeptRun& run, const py::object& directory, const py::object& video,
                    bool overwrite, const py::object& progress, const py::kwargs& keywords)
{
    const GivenKeywords given(keywords, OptionUse::pictures, "Run.draw");
    RenderRequest request;
    request.run = run.file();
    request.directory = pathOf(directory, "directory");
    request.video = video.is_none() ? "" : pathOf(video, "video");
    request.overwrite = overwrite;
    request.change = [&](Scene& scene)
    {
        given.apply(scene);
        if (!scene.frames.enabled)
        {
            throw Error(ErrorCode::usage, "frames=\"none\" leaves nothing to draw");
        }
    };
    Interrupts interrupts;
    RenderObserver observer;
    observer.stopRequested = interrupts.stopRequested();
    if (!progress.is_none())
    {
        observer.progressed = [&](std::size_t done, std::size_t all)
        {
            interrupts.report(progress, shareOf({.frames = done, .pictures = all}), true, false,
                              std::size_t{0}, 0.0);
        };
    }
    RenderResult result;
    {
        const py::gil_scoped_release release;
        result = renderRun(request, observer);
    }
    interrupts.throwIfHappened();
    if (const auto failure = failureOf(result))
    {
        throw *failure;
    }
    return result.frames;
}

std::string wordOf(py::handle value, const char* name)
{
    if (!py::isinstance<py::str>(value))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is {}, but it must be a str", name, shown(value)));
    }
    return value.cast<std::string>();
}

/// Reads the options of an export that were given.
ExportRequest exportRequestOf(const KeptRun& run, const std::string& format,
                              const py::object& folder, const py::dict& given)
{
    ExportRequest request;
    request.run = run.file();
    request.format = exportFormat(format).format;
    request.out = pathOf(folder, "path");
    for (const std::string_view option : exportOptions())
    {
        std::string keyword(option);
        std::replace(keyword.begin(), keyword.end(), '-', '_');
        if (given.contains(keyword))
        {
            requireOption(request.format, option);
        }
    }
    const auto take = [&](const char* name, auto&& read)
    {
        if (given.contains(name))
        {
            read(given[name], name);
        }
    };
    BedSettings& bed = request.bed;
    take("frames",
         [&](const py::object& value, const char* name) { request.frames = wordOf(value, name); });
    take("contacts", [&](const py::object& value, const char* name)
         { parseContacts(wordOf(value, name), bed); });
    take("measure",
         [&](const py::object& value, const char* name)
         {
             for (const py::handle each : value)
             {
                 request.measured.push_back(wordOf(each, name));
             }
         });
    take("cell",
         [&](const py::object& value, const char* name) { bed.cell = numberOf(value, name); });
    take("resolution",
         [&](const py::object& value, const char* name) { bed.resolution = countOf(value, name); });
    take("voxels",
         [&](const py::object& value, const char* name) { bed.voxels = countOf(value, name); });
    take("threads", [&](const py::object& value, const char* name)
         { bed.threads = static_cast<int>(std::min<std::size_t>(countOf(value, name), 32767)); });
    request.overwrite = given.contains("overwrite");
    request.fullMesh = given.contains("full_mesh");
    request.shell = !given.contains("no_shell");
    request.lids = given.contains("lids");
    bed.ascii = given.contains("ascii");
    return request;
}

std::vector<std::filesystem::path> exportInto(const KeptRun& run, const std::string& format,
                                              const py::object& folder, const py::dict& given)
{
    const ExportRequest request = exportRequestOf(run, format, folder, given);
    Interrupts interrupts;
    ExportResult result;
    try
    {
        const py::gil_scoped_release release;
        result =
            exportRun(request, [&](std::size_t, std::size_t) { return !interrupts.happened(); });
    }
    catch (const Error&)
    {
        interrupts.throwIfHappened();
        throw;
    }
    return result.files;
}

void addArrays(py::class_<KeptRun>& run)
{
    run.def_property_readonly("last", &KeptRun::last, "The last state: a Snapshot.")
        .def(
            "frame",
            [](KeptRun& r, const py::object& number)
            { return r.frame(wholeNumberOf(number, "number")); },
            py::arg("number"),
            "The state of a frame, by its number; -1 is the last. A Snapshot. Frames are read in "
            "order, so the next one is quick; for an earlier one reading starts again at the "
            "first.")
        .def("__getitem__", &KeptRun::at, py::arg("index"))
        .def("__len__", [](const KeptRun& r) { return r.reader().frames().size(); })
        .def_property_readonly(
            "frames",
            [](const KeptRun& r)
            {
                const auto& frames = r.reader().frames();
                return py::array_t<std::size_t>(static_cast<py::ssize_t>(frames.size()),
                                                frames.data());
            },
            "uint64 [f]: numbers of the frames that are kept, ascending.")
        .def_property_readonly(
            "vertices", [](const KeptRun& r) { return view(r.mesh(), r.mesh()->vertices); },
            "float64 [v, 3]: of the mesh as simulated, after repair.")
        .def_property_readonly(
            "triangles",
            [](const KeptRun& r)
            {
                const auto& triangles = r.mesh()->triangles;
                return view(r.mesh(), reinterpret_cast<const std::uint32_t*>(triangles.data()),
                            {static_cast<py::ssize_t>(triangles.size()), 3});
            },
            "uint32 [t, 3]: indices into vertices, counter-clockwise seen from outside.");
}

} // namespace

void addRun(py::module_& module)
{
    py::class_<KeptRun> run(module, "KeptRun");
    run.def(py::init(
                [](const py::object& path)
                {
                    const std::string text = pathOf(path, "the run");
                    const py::gil_scoped_release release;
                    return std::make_unique<KeptRun>(text);
                }),
            py::arg("path"));
    addArrays(run);
    run.def_property_readonly(
           "file", [](const KeptRun& r) { return r.file(); }, "pathlib.Path of the run file.")
        .def_property_readonly(
            "options", [](const KeptRun& r) { return keywordsOfScene(r.scene()); },
            "All settings of the run, by keyword.")
        .def_property_readonly("summary_text",
                               [](const KeptRun& r) { return r.reader().summary(); })
        .def("draw_frame", &KeptRun::render, py::arg("frame"))
        .def("draw_into", &drawRun, py::arg("directory"), py::arg("video"), py::arg("overwrite"),
             py::arg("progress"))
        .def("export_into", &exportInto);
    module.def("fill_into", &fillInto);
}

} // namespace frostfill::python
