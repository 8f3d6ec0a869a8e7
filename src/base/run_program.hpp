// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// Both ends of a pipe, which a program that is started does not inherit.
class Pipe
{
public:
    Pipe();
    ~Pipe();
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void closeReading();
    void closeWriting();
    [[nodiscard]] int error() const { return error_; } ///< errno when there is none
    [[nodiscard]] int reading() const { return ends_[0]; }
    [[nodiscard]] int writing() const { return ends_[1]; }

private:
    std::array<int, 2> ends_ = {-1, -1};
    int error_;
};

/// Descriptors that a program gets as its standard streams; -1 for none.
struct ProgramStreams
{
    int input = -1;
    int output = -1;
    int errors = -1;
};

struct StartedProgram
{
    pid_t id = -1;
    int error = 0; ///< errno when it could not be started; then nothing is left of it
};

/// Starts a program, found in PATH by the first argument, in a folder. It ends with the thread that
/// starts it, and inherits open files that are not marked to be closed. `leads`: it and the
/// programs that it starts are a process group of its number.
[[nodiscard]] StartedProgram startProgram(const std::filesystem::path& folder,
                                          std::vector<std::string> arguments,
                                          const ProgramStreams& streams, bool leads = false);

/// Waits until a child has ended, and returns how, as waitpid tells it.
int waitFor(pid_t id);
/// Exit code of a status of `waitpid`, or 128 + the signal that has ended the program.
[[nodiscard]] int exitCodeOf(int status);

/// How another program ended.
struct ProgramRun
{
    int error = 0; ///< errno when it could not be started
    int code = 0;  ///< exit code, or 128 + the signal that ended it
    std::string said;
};

/// Runs a program, found in PATH by the first argument, in a folder, without input; waits for its
/// end and keeps what it writes to either output. It ends with this process, and inherits its open
/// files that are not marked to be closed.
[[nodiscard]] ProgramRun runProgram(const std::filesystem::path& folder,
                                    std::vector<std::string> arguments);

} // namespace frostfill
