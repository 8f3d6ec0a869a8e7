// SPDX-License-Identifier: MIT
// Room: the figures of the documentation, each with its data and its gnuplot script. A new
// figure is one file and one line in registry.cpp.
#pragma once

#include "study/table.hpp"

#include <frostfill/image.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace frostfill
{

struct FigureRequest
{
    std::filesystem::path directory = "docs/figures";
    /// Where times that were measured before are taken from, so that figures can be drawn again
    /// without their changing.
    std::filesystem::path recorded = "docs/figures";
    bool measure = false; ///< measure times anew
    bool quick = false;   ///< few spheres, for a look and for tests
    bool pdf = false;     ///< also draw NAME.pdf
    std::string object;   ///< of objectFigures: a built-in mesh or a file
    std::function<void(const std::string&)> say = [](const std::string&) {};
    /// Hears how far the figure is that is being made: parts done, parts in all, what has ended.
    std::function<void(std::size_t, std::size_t, const std::string&)> progress =
        [](std::size_t, std::size_t, const std::string&) {};
};

/// The folder that a figure's files go to.
class FigureFolder
{
public:
    explicit FigureFolder(const FigureRequest& request) : request_(request) {}

    void write(const std::string& name, std::string_view text) const;
    void write(const std::string& name, const Table& table) const;
    void write(const std::string& name, const Image& image) const;

    /// Copies a file of measured times from the recorded ones. False when there is none or when
    /// times are to be measured anew: then the caller measures and writes it.
    [[nodiscard]] bool reuse(const std::string& name) const;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const
    {
        return request_.directory / name;
    }
    [[nodiscard]] bool quick() const { return request_.quick; }
    [[nodiscard]] const std::string& object() const { return request_.object; }
    void say(const std::string& what) const { request_.say(what); }
    [[nodiscard]] const auto& progress() const { return request_.progress; }

private:
    const FigureRequest& request_;
};

/// One figure of the documentation.
struct Figure
{
    const char* name;
    const char* title;
    bool measured;  ///< shows times, which differ from run to run
    double seconds; ///< that it takes to make, roughly and in proportion to the others
    /// Writes the data that the script reads.
    void (*makeData)(const FigureFolder&);
    /// The gnuplot script: reads the data, draws NAME.svg or NAME.png. Null where makeData draws.
    std::string_view (*script)();
};

/// Those of the documentation. A new figure is a file that defines one and a line in registry.cpp.
[[nodiscard]] std::span<const Figure> allFigures();

/// Those of one object, which the request names.
[[nodiscard]] std::span<const Figure> objectFigures();

/// Makes one figure: its data, its script, NAME.svg, NAME.png and, if wanted, NAME.pdf. Throws
/// Error, missingProgram without gnuplot where there is a script.
void makeFigure(const Figure& figure, const FigureRequest& request);

/// Draws one figure from data that are there already. Throws like makeFigure.
void drawFigure(const Figure& figure, const FigureRequest& request);

} // namespace frostfill
