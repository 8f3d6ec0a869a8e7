// SPDX-License-Identifier: MIT
// The reader in examples/ that docs/run-file.md names reads what the library writes.
#include "support/temporary_folder.hpp"
#include "unit/run_file/recorded_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace frostfill
{
namespace
{

using test::readFile;
using test::writeFile;

/// Debian's own interpreter, for which its modules are.
constexpr const char* kPython = "/usr/bin/python3";

int run(const std::string& command)
{
    return std::system(command.c_str()); // NOLINT(cert-env33-c): of our own words
}

TEST(DocumentedReader, ReadsEveryFrameAndTheRestingPlacesExactly)
{
    if (run(fmt::format("{} -c 'import numpy, zstandard' 2>/dev/null", kPython)) != 0)
    {
        GTEST_SKIP() << "python3-numpy or python3-zstandard is not installed";
    }
    const test::TemporaryFolder folder;
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.count = 40;
    const test::RecordedRun recorded = test::recordRun(scene, folder / "run.frost");
    const std::string code = readFile(FROSTFILL_EXAMPLES "/read_run.py");
    EXPECT_LE(std::count(code.begin(), code.end(), '\n'), 66);
    writeFile(folder / "reader.py", code);
    writeFile(folder / "all.py",
              "import sys, numpy as np, reader\n"
              "for n, time, c, r, s, columns in reader.frames(sys.argv[1]):\n"
              "    print(n, repr(float(time)), len(r), (s == 0).sum(), (s == 1).sum(), "
              "(columns['contacts'] * (1 + np.arange(len(r)))).sum())\n"
              "for i in range(len(r)):\n"
              "    print(*(float(x).hex() for x in c[i]), s[i])\n");
    ASSERT_EQ(run(fmt::format("cd '{0}' && {1} all.py run.frost >out.txt 2>errors.txt",
                              folder.path().string(), kPython)),
              0)
        << readFile(folder / "errors.txt");

    std::string expected;
    for (std::size_t k = 0; k < recorded.frames.size(); ++k)
    {
        const Snapshot& frame = recorded.frames[k];
        std::size_t contacts = 0; // of each sphere as often as its place in the row
        for (std::size_t id = 0; id < frame.radii.size(); ++id)
        {
            contacts += (id + 1) * frame.columns.front().bits[id];
        }
        expected += fmt::format("{} {:.17g} {} {} {} {}\n", recorded.numbers[k], frame.time,
                                frame.radii.size(), frame.running, frame.frozen, contacts);
    }
    std::istringstream lines(readFile(folder / "out.txt"));
    std::istringstream expectedLines(expected);
    std::string line;
    for (std::string wanted; std::getline(expectedLines, wanted);)
    {
        std::getline(lines, line);
        std::istringstream a(line);
        std::istringstream b(wanted);
        double x = 0;
        double y = 0;
        while (b >> y)
        {
            ASSERT_TRUE(a >> x) << line;
            EXPECT_EQ(x, y) << line << " / " << wanted;
        }
    }
    for (const SphereRecord& sphere : recorded.spheres)
    {
        std::getline(lines, line);
        const char* at = line.c_str();
        for (int axis = 0; axis < 3; ++axis)
        {
            char* end = nullptr;
            EXPECT_EQ(std::strtod(at, &end), sphere.centre[axis]) << line;
            at = end;
        }
        EXPECT_EQ(std::atoi(at), static_cast<int>(sphere.state)) << line;
    }
}

} // namespace
} // namespace frostfill
