// SPDX-License-Identifier: MIT
#pragma once

#include "base/run_program.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace frostfill
{

/// A program that is spoken with by lines of text, through its standard input and output. What it
/// writes is taken while it is written to, so neither waits forever for the other to read. It
/// ends, and so do the programs that it has started, with this object.
class ProgramTalk
{
public:
    /// `seconds`: wall-clock time, after which nothing is waited for any more.
    ProgramTalk(const std::string& program, double seconds);
    ~ProgramTalk();
    ProgramTalk(const ProgramTalk&) = delete;
    ProgramTalk& operator=(const ProgramTalk&) = delete;

    /// errno when it could not be started.
    [[nodiscard]] int error() const { return error_; }

    /// Goes out with the next question, or when there is much of it.
    void say(std::string_view text);
    /// Its next line. None when none can come: then `ending` says why.
    [[nodiscard]] std::optional<std::string> hear();
    /// Nothing more is said: it may end by itself for a moment, then it is ended.
    void end();

    /// Processor time of the program with all its threads. [s] After `end` it includes the programs
    /// that it has started and waited for.
    [[nodiscard]] double seconds() const;
    /// Why nothing can be heard: "ended with code 3". Ends the program.
    [[nodiscard]] std::string ending();
    /// The last that it wrote to its standard error.
    [[nodiscard]] std::string errors() const;

private:
    using Clock = std::chrono::steady_clock;

    void sendAll();
    void exchange();
    void write();
    void read();
    void closeInput();
    [[nodiscard]] bool canHear() const;
    [[nodiscard]] bool endsWithin(Clock::duration time) const;
    void reap();

    Pipe output_;
    int error_;
    int input_ = -1;  ///< of the program: our end of a socket
    int errors_;      ///< a file in memory
    pid_t id_ = -1;   ///< -1 when it does not run
    double patience_; ///< [s]
    Clock::time_point deadline_;
    std::string outgoing_;
    std::string said_;
    std::size_t heard_ = 0; ///< of what was said [byte]
    bool late_ = false;
    int status_ = 0;         ///< of its end
    double usedSeconds_ = 0; ///< once it has ended
};

} // namespace frostfill
