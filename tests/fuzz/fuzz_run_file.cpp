// SPDX-License-Identifier: MIT
// Any bytes as the frames of a run file, behind sums that are right, so that they reach the
// decoder. A state that is decoded agrees with itself, and is the same when it is sought from the
// beginning.
#include "run_file/file_of_run.hpp"
#include "run_file/records.hpp"

#include <frostfill/error.hpp>
#include <frostfill/run_file.hpp>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

namespace
{

using namespace frostfill;

constexpr std::string_view kMesh = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                   "property float y\nproperty float z\nelement face 4\n"
                                   "property list uchar int vertex_indices\nend_header\n"
                                   "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// Input: frames of each of two records, the length of the first, 16 bits, four doubles of the
/// head, and the bytes of the records.
struct Header
{
    std::array<std::uint8_t, 2> frames;
    std::uint16_t first;
    std::array<double, 4> head;
};

std::string fileOf(const std::uint8_t* data, std::size_t size)
{
    Header header;
    std::memcpy(header.frames.data(), data, 2);
    std::memcpy(&header.first, data + 2, 2);
    std::memcpy(header.head.data(), data + 4, sizeof header.head);
    const std::string_view rest(reinterpret_cast<const char*>(data) + 36, size - 36);
    const std::string_view head(reinterpret_cast<const char*>(header.head.data()),
                                sizeof header.head);
    const std::size_t first = std::min<std::size_t>(header.first, rest.size());
    static const std::string mesh = packRecord(RecordKind::mesh, {}, kMesh);
    std::string file = std::string(kRunFileMagic) + packRecord(RecordKind::head, {}, head) + mesh;
    std::uint32_t number = 0;
    for (const std::size_t record : {0U, 1U})
    {
        std::vector<std::uint32_t> numbers(header.frames[record] % 8U);
        std::iota(numbers.begin(), numbers.end(), number);
        number += static_cast<std::uint32_t>(numbers.size());
        file += packRecord(RecordKind::frames, numbers,
                           record == 0 ? rest.substr(0, first) : rest.substr(first));
    }
    return file;
}

void require(bool holds)
{
    if (!holds)
    {
        std::abort();
    }
}

void check(const Snapshot& state, const RunFileReader& reader)
{
    const std::size_t count = state.states.size();
    require(state.centres.size() == count && state.radii.size() == count);
    require(reader.centres().size() == count && reader.radii().size() == count);
    std::size_t counted = 0;
    for (std::size_t id = 0; id < count; ++id)
    {
        require(state.states[id] <= SphereState::discarded);
        counted += state.waits(id) ? 0 : 1;
    }
    require(state.running + state.frozen + state.discarded == counted);
    require(std::is_sorted(state.changed.begin(), state.changed.end()));
    require(state.changed.empty() || state.changed.back() < count);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 36)
    {
        return 0;
    }
    static const int memory = memfd_create("run.frost", 0);
    const std::string file = fileOf(data, size);
    require(memory >= 0 && ftruncate(memory, 0) == 0 &&
            pwrite(memory, file.data(), file.size(), 0) == static_cast<ssize_t>(file.size()));
    try
    {
        RunFileReader reader("/proc/self/fd/" + std::to_string(memory));
        requireFrames(reader, "fuzzed");
        std::vector<SphereState> last;
        for (std::size_t i = 0; i < reader.frames().size(); ++i)
        {
            const Snapshot& state = reader.seek(i);
            check(state, reader);
            last = state.states;
            if (i % 3 == 0)
            {
                reader.forgetChanges();
            }
        }
        (void)reader.seek(0);
        require(reader.seek(reader.frames().size() - 1).states == last);
    }
    catch (const Error&)
    {
        return 0;
    }
    return 0;
}
