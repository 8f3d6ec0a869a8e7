// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "run/run_files.hpp"

#include <frostfill/error.hpp>
#include <frostfill/measure.hpp>
#include <frostfill/renderer.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <sstream>
#include <string>

namespace frostfill
{
namespace
{

/// The path of a program in PATH; empty if it is not there.
std::string findProgram(const std::string& name)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
    {
        const std::filesystem::path file = std::filesystem::path(folder) / name;
        if (std::filesystem::is_regular_file(file) && access(file.c_str(), X_OK) == 0)
        {
            return file.string();
        }
    }
    return {};
}

void printMachine()
{
    const MachineInfo machine = describeMachine();
    fmt::print("frostfill {} ({}, {})\n", FROSTFILL_VERSION, machine.build, machine.compiler);
    fmt::print("machine   {}, {} cores, {:.1f} GiB, {}\n", machine.cpu, machine.cores,
               machine.memoryGib, machine.system);
    for (const auto& [library, version] : libraryVersions())
    {
        fmt::print("library   {} {}\n", library, version);
    }
    fmt::print("font      compiled in\n");
}

/// Programs for videos and figures. A run works without them.
void printPrograms()
{
    for (const auto& [program, package] :
         {std::pair{"ffmpeg", "ffmpeg"}, {"python3", "python3-matplotlib"}})
    {
        const std::string file = findProgram(program);
        if (file.empty())
        {
            fmt::print("program   {} is missing; optional: apt-get install {}\n", program, package);
        }
        else
        {
            fmt::print("program   {}\n", file);
        }
    }
}

/// Who draws and why, and whether there is all that the program can use for it.
void printVerdict(std::span<const BackendAttempt> attempts)
{
    fmt::print(
        "pictures  The processor draws them in tiles (picture.backend=builtin), because that gives "
        "the picture of OpenGL in software in less time.\n"
        "          OSMesa (picture.backend=osmesa) is OpenGL without a screen, as the paper used "
        "it; frostfill fps measures both.\n");
    const auto works = [](const BackendAttempt& attempt) { return attempt.works; };
    const bool hasOsmesa = std::any_of(attempts.begin(), attempts.end(),
                                       [&](const BackendAttempt& attempt)
                                       { return works(attempt) && attempt.name == "osmesa"; });
    fmt::print("{}\n", hasOsmesa ? "all is well"
                       : std::any_of(attempts.begin(), attempts.end(), works)
                           ? "OSMesa is missing: without it, pictures are drawn all the same"
                           : "OSMesa is missing, and no OpenGL is available: without it, "
                             "pictures are drawn all the same");
}

int examine()
{
    printMachine();
    const auto attempts = probeBackends();
    for (const BackendAttempt& attempt : attempts)
    {
        fmt::print("OpenGL    {}: {}{}\n", attempt.name,
                   attempt.works ? "" : "does not work: ", attempt.description);
        if (!attempt.works && !attempt.remedy.empty())
        {
            fmt::print("          optional: {}\n", attempt.remedy);
        }
    }
    printPrograms();
    printVerdict(attempts);
    return 0;
}

} // namespace

Command addDoctorCommand(CLI::App& program)
{
    program
        .add_subcommand("doctor", "Show which OpenGL and libraries are present and what is missing")
        ->footer("Examples:\n  frostfill doctor\n");
    return [] { return examine(); };
}

} // namespace frostfill
