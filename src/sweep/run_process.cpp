// SPDX-License-Identifier: MIT
#include "sweep/run_record.hpp"

#include <frostfill/failure.hpp>
#include <frostfill/sweep.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <tuple>

namespace frostfill
{
namespace
{

using PlainJson = nlohmann::json;

constexpr int kPatience = 100; // between two looks whether to stop [ms]

RunReport reportOf(const FillResult& result)
{
    if (const auto failure = failureOf(result))
    {
        return failed(*failure);
    }
    if (result.stopped)
    {
        return {RunStatus::stopped, static_cast<int>(ErrorCode::stoppedEarly),
                fmt::format("stopped with {} spheres", result.spheres)};
    }
    return {RunStatus::done, 0, ""};
}

/// How the process ended, if it could not say so itself.
RunReport reportOf(int status)
{
    if (WIFSIGNALED(status))
    {
        const int signal = WTERMSIG(status);
        return {RunStatus::failed, 128 + signal,
                fmt::format("its process was ended by a signal: {}{}", strsignal(signal),
                            signal == SIGKILL ? "; perhaps there was not enough memory" : "")};
    }
    return failed(Error(ErrorCode::postcondition,
                        fmt::format("its process ended without a message, with exit code {}",
                                    WEXITSTATUS(status))));
}

RunReport noProcess()
{
    return failed(Error(ErrorCode::outOfMemory,
                        fmt::format("cannot start a process: {}", std::strerror(errno))));
}

[[noreturn]] void runInChild(const FillRequest& request, const FillObserver& observer, int pipe,
                             pid_t parent)
{
    // It must end when its parent does.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
    {
        _exit(static_cast<int>(ErrorCode::stoppedEarly));
    }
    const RunReport report = runHere(request, observer);
    const std::string text = PlainJson{
        {"status", static_cast<int>(report.status)},
        {"exit_code", report.exitCode},
        {"message",
         report.message}}.dump(-1, ' ', false, PlainJson::error_handler_t::replace);
    std::ignore = write(pipe, text.data(), text.size());
    std::fflush(nullptr);
    _exit(0);
}

/// What the process writes until it ends; passes the wish to stop on to it, once.
std::string readAll(int pipe, pid_t child, const std::function<bool()>& stopRequested)
{
    std::string text;
    bool told = false;
    while (true)
    {
        if (!told && stopRequested && stopRequested())
        {
            kill(child, SIGTERM);
            told = true;
        }
        pollfd request = {pipe, POLLIN, 0};
        if (poll(&request, 1, kPatience) <= 0)
        {
            continue;
        }
        std::array<char, 4096> buffer{};
        const ssize_t count = read(pipe, buffer.data(), buffer.size());
        if (count == 0 || (count < 0 && errno != EINTR))
        {
            return text;
        }
        text.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    }
}

} // namespace

RunReport runHere(const FillRequest& request, const FillObserver& observer)
{
    try
    {
        return reportOf(fill(request, observer));
    }
    catch (...)
    {
        const Failure why = currentFailure();
        return failed(Error(why.code, why.message));
    }
}

RunReport runApart(const FillRequest& request, const FillObserver& observer)
{
    std::array<int, 2> pipes{};
    if (pipe2(pipes.data(), O_CLOEXEC) != 0)
    {
        return noProcess();
    }
    std::fflush(nullptr); // or the child prints it once more
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0)
    {
        close(pipes[0]);
        runInChild(request, observer, pipes[1], parent);
    }
    close(pipes[1]);
    if (child < 0)
    {
        close(pipes[0]);
        return noProcess();
    }
    const std::string text = readAll(pipes[0], child, observer.stopRequested);
    close(pipes[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
    const PlainJson json = PlainJson::parse(text, nullptr, false);
    return json.is_object()
               ? RunReport{static_cast<RunStatus>(json.at("status").get<int>()),
                           json.at("exit_code").get<int>(), json.at("message").get<std::string>()}
               : reportOf(status);
}

} // namespace frostfill
