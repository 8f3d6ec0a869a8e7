// SPDX-License-Identifier: MIT
#pragma once

#include "support/temporary_folder.hpp"

#include <frostfill/import.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill::test
{

/// All that a run file says of a frame.
struct ReadFrame
{
    double time = 0;
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> radii;
    std::vector<SphereState> states;
    std::vector<std::uint32_t> groups;
    std::vector<float> speeds;
    std::vector<std::uint32_t> contacts; ///< empty if the run has none
    friend bool operator==(const ReadFrame&, const ReadFrame&) = default;
};

/// The different states of a run.
inline std::vector<ReadFrame> framesOf(const std::filesystem::path& directory)
{
    RunFileReader reader(directory / "run.frost");
    std::vector<ReadFrame> frames;
    std::uint64_t before = 0;
    for (std::size_t k = 0; k < reader.frames().size(); ++k)
    {
        const Snapshot& state = reader.seek(k);
        if (k > 0 && reader.revision() == before)
        {
            continue;
        }
        before = reader.revision();
        frames.push_back(
            {state.time, reader.centres(), reader.radii(), state.states, state.groups, state.speeds,
             state.columns.empty() ? std::vector<std::uint32_t>() : state.columns.front().bits});
    }
    return frames;
}

/// A step of a dump in a box from -1 to 1.
inline std::string dumpStep(int step, const std::string& columns,
                            const std::vector<std::string>& rows)
{
    std::string text = fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n"
                                   "ITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\nITEM: ATOMS {}\n",
                                   step, rows.size(), columns);
    for (const std::string& row : rows)
    {
        text += row + "\n";
    }
    return text;
}

} // namespace frostfill::test
