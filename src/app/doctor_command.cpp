// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "run/machine_json.hpp"

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

/// How far pictures of OSMesa are from those of the processor, and how much longer they take.
constexpr const char* kApart = "0.4";
constexpr const char* kTimes = "3 to 7";

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
         {std::pair{"ffmpeg", "ffmpeg"}, {"gnuplot", "gnuplot-nox"}})
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

/// Who draws, how nearly others draw the same, and how fast: the bound of the test RandomAgreement,
/// and what `frostfill fps` measures.
void printVerdict(std::span<const BackendAttempt> attempts)
{
    const auto found = std::find_if(attempts.begin(), attempts.end(),
                                    [](const BackendAttempt& attempt) { return attempt.works; });
    fmt::print("all is well: the processor draws every picture, without OpenGL (--backend "
               "builtin), unless another backend is asked for\n");
    const std::string how = fmt::format("the same pictures, within {} of 255 (root mean square), "
                                        "in {} times the time; frostfill fps measures both",
                                        kApart, kTimes);
    if (found == attempts.end())
    {
        fmt::print("no OpenGL is available; it would draw {}\n", how);
        return;
    }
    fmt::print("--backend {} draws {}\n", found->name, how);
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
