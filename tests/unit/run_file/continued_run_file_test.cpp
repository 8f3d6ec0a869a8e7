// SPDX-License-Identifier: MIT
// A run that is resumed goes on with its file: what is equal stays.
#include "support/temporary_folder.hpp"
#include "unit/run_file/recorded_run.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::readFile;
using test::writeFile;

class ContinuedRunFile : public ::testing::Test
{
protected:
    ContinuedRunFile()
    {
        scene_.spheres.count = 40;
        test::recordRun(scene_, file_, 1);
        whole_ = readFile(file_);
    }
    Scene scene_ = presetScene(Preset::fast, "torus");
    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "run.frost";
    std::string whole_;
};

TEST_F(ContinuedRunFile, EndsInTheSameBytesWhereverItWasCut)
{
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{100}, whole_.size() / 2, whole_.size() - 1, whole_.size()})
    {
        writeFile(file_, whole_.substr(0, length));
        test::recordRun(scene_, file_, 1, EarlierFile::continued);
        EXPECT_EQ(readFile(file_), whole_) << length;
    }
}

TEST_F(ContinuedRunFile, EndsInTheSameBytesAfterAnyFalseEnd)
{
    std::string stopped = whole_.substr(0, whole_.size() / 2);
    stopped += "what a stopped run has written at its end, and more of it, ";
    stopped += whole_;
    writeFile(file_, stopped);
    test::recordRun(scene_, file_, 1, EarlierFile::continued);
    EXPECT_EQ(readFile(file_), whole_);
}

TEST_F(ContinuedRunFile, LosesNothingWhileItIsRepeated)
{
    const std::string begun = whole_.substr(0, 3 * whole_.size() / 4);
    writeFile(file_, begun);
    {
        const TriangleMesh mesh = loadMesh("torus").mesh;
        const Simulation simulation(scene_, mesh);
        const RunFileWriter writer(file_, R"({"name": "test"})", mesh, simulation.smallestRadius(),
                                   EarlierFile::continued);
    } // killed once more
    EXPECT_EQ(readFile(file_), begun);
}

TEST_F(ContinuedRunFile, OfAnotherRunIsReplaced)
{
    scene_.spheres.count = 30;
    test::recordRun(scene_, file_, 1, EarlierFile::continued);
    EXPECT_LT(readFile(file_).size(), whole_.size());
    EXPECT_EQ(RunFileReader(file_).wholeBytes(), readFile(file_).size());
}

} // namespace
} // namespace frostfill
