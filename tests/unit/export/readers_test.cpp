// SPDX-License-Identifier: MIT
// What is exported is read by others: by hand with Python's standard library, and by the programs
// that it is meant for, where they are installed. Each compares what it reads with the run.
#include "unit/export/exported_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace frostfill
{
namespace
{

using test::readFile;

struct Reader
{
    const char* name;
    const char* format;
    const char* there;   ///< a command that succeeds where the reader is installed
    const char* command; ///< {0}: the folder of the scripts, {1}: that of the run, {2}: the format
};

int run(const std::string& command)
{
    return std::system(command.c_str()); // NOLINT(cert-env33-c): of our own words
}

class Readers : public ::testing::TestWithParam<std::tuple<Reader, bool>>
{
};

TEST_P(Readers, FindEveryNumberOfTheRun)
{
    const auto& [reader, moved] = GetParam();
    if (run(fmt::format("{} >/dev/null 2>&1", reader.there)) != 0)
    {
        GTEST_SKIP() << reader.name << " is not installed";
    }
    const test::TemporaryFolder folder;
    test::recordWithOracle(test::fewSpheres(moved), folder.path());
    const ExportFormat format = exportFormat(reader.format).format;
    const auto write = [&](ExportFormat each, const char* frames)
    {
        exportRun({.run = folder.path(),
                   .format = each,
                   .frames = frames,
                   .out = folder / "export",
                   .overwrite = true});
    };
    const bool lastOnly = format == ExportFormat::glbInstanced || format >= ExportFormat::liggghts;
    write(format, lastOnly ? "last" : "all");
    if (format == ExportFormat::lammpsDump)
    {
        write(ExportFormat::lammps, "last"); // LAMMPS reads a dump into what is there
    }
    const std::string command = fmt::format(fmt::runtime(reader.command), FROSTFILL_READERS,
                                            folder.path().string(), reader.format);
    EXPECT_EQ(run(fmt::format("{} >'{}' 2>&1", command, (folder / "said.txt").string())), 0)
        << readFile(folder / "said.txt");
}

std::string nameOfTest(const ::testing::TestParamInfo<std::tuple<Reader, bool>>& instance)
{
    const auto& [reader, moved] = instance.param;
    std::string name =
        fmt::format("{}_{}{}", reader.name, reader.format, moved ? "_ofAMovedObject" : "");
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

constexpr const char* kByHand = "/usr/bin/python3 '{0}/by_hand.py' '{1}' {2}";

INSTANTIATE_TEST_SUITE_P(
    Of, Readers,
    ::testing::Combine(
        ::testing::Values(Reader{"Hand", "csv", "/usr/bin/python3 -V", kByHand},
                          Reader{"Hand", "xyz", "/usr/bin/python3 -V", kByHand},
                          Reader{"Hand", "lammps-dump", "/usr/bin/python3 -V", kByHand},
                          Reader{"Hand", "vtp", "/usr/bin/python3 -V", kByHand},
                          Reader{"Hand", "glb", "/usr/bin/python3 -V", kByHand},
                          Reader{"Hand", "glb-instanced", "/usr/bin/python3 -V", kByHand},
                          Reader{"Vtk", "vtp", "/usr/bin/python3 -c 'import vtkmodules.vtkIOXML'",
                                 "/usr/bin/python3 '{0}/with_vtk.py' '{1}' {2}"},
                          Reader{"Paraview", "vtp", "which pvpython",
                                 "pvpython '{0}/with_paraview.py' '{1}' {2}"},
                          Reader{"Ase", "xyz", "/usr/bin/python3 -c 'import ase'",
                                 "/usr/bin/python3 '{0}/with_ase.py' '{1}' {2}"},
                          Reader{"Lammps", "lammps-dump", "which lmp",
                                 "/usr/bin/python3 '{0}/with_lammps.py' '{1}' {2}"},
                          Reader{"F3d", "glb", "which f3d xvfb-run",
                                 "/usr/bin/python3 '{0}/with_f3d.py' '{1}' {2}"},
                          Reader{"Blender", "glb", "which blender",
                                 "blender -b --factory-startup --python-exit-code 1 --python "
                                 "'{0}/with_blender.py' -- '{1}' {2}"}),
        ::testing::Bool()),
    nameOfTest);

constexpr const char* kInputsByHand = "/usr/bin/python3 '{0}/inputs_by_hand.py' '{1}' {2}";
constexpr const char* kWithInputs = "/usr/bin/python3 '{0}/with_inputs.py' '{1}' {2}";

INSTANTIATE_TEST_SUITE_P(
    OfInputs, Readers,
    ::testing::Combine(
        ::testing::Values(Reader{"Hand", "liggghts", "/usr/bin/python3 -V", kInputsByHand},
                          Reader{"Hand", "lammps", "/usr/bin/python3 -V", kInputsByHand},
                          Reader{"Hand", "yade", "/usr/bin/python3 -V", kInputsByHand},
                          Reader{"Hand", "mercurydpm", "/usr/bin/python3 -V", kInputsByHand},
                          Reader{"Hand", "mfix", "/usr/bin/python3 -V", kInputsByHand},
                          Reader{"Hand", "lethe", "/usr/bin/python3 -V", kInputsByHand},
                          Reader{"Liggghts", "liggghts", "which liggghts", kWithInputs},
                          Reader{"Lammps", "lammps", "which lmp", kWithInputs},
                          Reader{"Yade", "yade", "which yade", kWithInputs}),
        ::testing::Bool()),
    nameOfTest);

} // namespace
} // namespace frostfill
