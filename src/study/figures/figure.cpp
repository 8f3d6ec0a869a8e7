// SPDX-License-Identifier: MIT
#include "study/figures/figure.hpp"

#include "base/atomic_file.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/figures/gnuplot.hpp"

#include <frostfill/error.hpp>
#include <frostfill/view.hpp>

#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// The palette of the pictures, as gnuplot variables, so that figures use the same colours.
std::string paletteScript(Look look)
{
    const Palette palette = paletteOf(look);
    std::string text;
    const auto define = [&](const char* name, const Colour& colour)
    {
        text += fmt::format("{}_colour = \"#{:02x}{:02x}{:02x}\"\n", name, colour[0], colour[1],
                            colour[2]);
    };
    define("running", palette.running);
    define("frozen", palette.frozen);
    define("discarded", palette.discarded);
    define("discarded_polygon", palette.discardedPolygon);
    return text;
}

} // namespace

void FigureFolder::write(const std::string& name, std::string_view text) const
{
    AtomicFile out(request_.directory / name);
    out.write(text);
    out.commit();
}

void FigureFolder::write(const std::string& name, const Table& table) const
{
    write(name, formatCsv(table));
}

void FigureFolder::write(const std::string& name, const Image& image) const
{
    savePng(image, request_.directory / name);
}

bool FigureFolder::reuse(const std::string& name) const
{
    const std::filesystem::path before = request_.recorded / name;
    const std::filesystem::path here = request_.directory / name;
    if (request_.measure || request_.quick || !std::filesystem::exists(before))
    {
        return false;
    }
    std::error_code error;
    if (!std::filesystem::equivalent(before, here, error))
    {
        std::filesystem::copy_file(before, here, std::filesystem::copy_options::overwrite_existing,
                                   error);
    }
    else
    {
        error.clear();
    }
    if (error)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", here.string(), error.message()));
    }
    say(fmt::format("{}: times from {}; --measure measures them again", name, before.string()));
    return true;
}

void makeFigure(const Figure& figure, const FigureRequest& request)
{
    if (figure.script)
    {
        requireGnuplot();
    }
    createDirectory(request.directory);
    const FigureFolder folder(request);
    request.say(fmt::format("{}: {}", figure.name, figure.title));
    figure.makeData(folder);
    if (figure.script)
    {
        drawFigure(figure, request);
    }
}

void drawFigure(const Figure& figure, const FigureRequest& request)
{
    const FigureFolder folder(request);
    const std::string script = fmt::format("{}.gp", figure.name);
    folder.write("style.gp", std::string(embedded::figure_style()) +
                                 paletteScript(request.object.empty() ? Look::paper : Look::clean));
    folder.write(script, figure.script());
    for (const char* format : {"svg", "png", "pdf"})
    {
        if (request.pdf || std::string_view(format) != "pdf")
        {
            runGnuplot(request.directory, script, format);
        }
    }
}

} // namespace frostfill
