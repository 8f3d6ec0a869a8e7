// SPDX-License-Identifier: MIT
#include "base/run_program.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

extern char** environ;

namespace frostfill
{

ProgramRun runProgram(const std::filesystem::path& folder, std::vector<std::string> arguments)
{
    ProgramRun ran;
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
    {
        ran.error = errno;
        return ran;
    }
    std::vector<char*> raw;
    for (std::string& argument : arguments)
    {
        raw.push_back(argument.data());
    }
    raw.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    pid_t child = 0;
    ran.error = posix_spawnp(&child, raw.front(), &actions, nullptr, raw.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (ran.error == 0)
    {
        std::array<char, 4096> buffer{};
        for (;;)
        {
            const ssize_t size = read(ends[0], buffer.data(), buffer.size());
            if (size > 0)
            {
                ran.said.append(buffer.data(), static_cast<std::size_t>(size));
            }
            else if (size == 0 || errno != EINTR)
            {
                break;
            }
        }
        int status = 0;
        while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        {
        }
        ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    close(ends[0]);
    return ran;
}

} // namespace frostfill
