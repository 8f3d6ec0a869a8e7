// SPDX-License-Identifier: MIT
#pragma once

#include "base/resources.hpp"
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace frostfill::test
{

inline const std::string kSmall = "fill cube --radius 0.3 --count 8 --set spheres.group_size=2 "
                                  "--size 64x48 --set frames.limit=4 --set threads=1 ";
// Takes far longer than any test waits.
inline const std::string kLong =
    "fill cube --count 200000 --size 64x48 --set frames.limit=4 --set threads=1 ";

class Environment : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments,
                             const std::string& environment = "") const
    {
        return test::runProgram(arguments, folder_.path(), environment);
    }
    /// With settings of fault_shim.c; false when the shim cannot be used.
    [[nodiscard]] static std::string shim(const std::string& settings)
    {
        return "LD_PRELOAD='" FROSTFILL_FAULT_SHIM "' " + settings;
    }
    [[nodiscard]] static bool hasShim()
    {
#ifdef FROSTFILL_SANITIZED
        return false;
#else
        return true;
#endif
    }
    void makeFfmpeg(const std::string& script) const
    {
        std::filesystem::create_directory(folder_ / "bin");
        writeFile(folder_ / "bin/ffmpeg", "#!/bin/sh\n" + script);
        std::filesystem::permissions(folder_ / "bin/ffmpeg", std::filesystem::perms::owner_all);
    }
    test::TemporaryFolder folder_;
};

} // namespace frostfill::test
