// SPDX-License-Identifier: MIT
#include "fault/program.hpp"

#include "support/temporary_folder.hpp"

#include <sys/wait.h>

#include <cstdlib>

namespace frostfill::test
{

Answer runProgram(const std::string& arguments, const std::string& folder,
                  const std::string& environment, const std::string& program)
{
    const std::string command = "cd '" + folder + "' && { " + environment + " '" + program + "' " +
                                arguments + "; } >answer.out 2>answer.err";
    const int status = std::system(command.c_str());
    Answer answer;
    answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    answer.output = readFile(folder + "/answer.out");
    answer.errors = readFile(folder + "/answer.err");
    return answer;
}

} // namespace frostfill::test
