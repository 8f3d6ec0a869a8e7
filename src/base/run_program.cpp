// SPDX-License-Identifier: MIT
#include "base/run_program.hpp"

#include "base/start_program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

namespace frostfill
{
namespace
{

/// All that comes through a pipe until its other end is closed.
std::string readAll(int pipe)
{
    std::string said;
    std::array<char, 4096> buffer{};
    for (;;)
    {
        const ssize_t size = read(pipe, buffer.data(), buffer.size());
        if (size > 0)
        {
            said.append(buffer.data(), static_cast<std::size_t>(size));
        }
        else if (size == 0 || errno != EINTR)
        {
            return said;
        }
    }
}

} // namespace

ProgramRun runProgram(const std::filesystem::path& folder, std::vector<std::string> arguments)
{
    ProgramRun ran;
    Pipe output;
    ran.error = output.error();
    if (ran.error != 0)
    {
        return ran;
    }
    const StartedProgram program =
        startProgram(folder, std::move(arguments),
                     {.input = -1, .output = output.writing(), .errors = output.writing()});
    ran.error = program.error;
    if (ran.error != 0)
    {
        ran.code = 127; // that of a shell
        return ran;
    }
    output.closeWriting();
    ran.said = readAll(output.reading());
    int status = 0;
    while (waitpid(program.id, &status, 0) < 0 && errno == EINTR)
    {
    }
    ran.code = exitCodeOf(status);
    return ran;
}

} // namespace frostfill
