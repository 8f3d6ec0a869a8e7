// SPDX-License-Identifier: MIT
#include "app/progress/json_progress.hpp"

#include "app/progress/stop_signals.hpp"

#include <frostfill/failure.hpp>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <tuple>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr double kSecondsPerObject = 0.25;

const char* resultOf(int code)
{
    return code == 0                                           ? "done"
           : code == static_cast<int>(ErrorCode::stoppedEarly) ? "stopped"
                                                               : "failed";
}

std::string endLine(int code, const std::string& message)
{
    return Json{{"stage", "end"},
                {"result", resultOf(code)},
                {"exit_code", code},
                {"message", message}}
               .dump(-1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

double seconds(std::chrono::steady_clock::duration time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

void JsonProgress::addTo(CLI::App& command, const char* group)
{
    command
        .add_option_function<int>(
            "--json-progress",
            [this](int descriptor)
            {
                if (fcntl(descriptor, F_GETFL) < 0)
                {
                    throw Error(ErrorCode::usage,
                                fmt::format("--json-progress is {}, but no such file descriptor "
                                            "is open; 2 is standard error",
                                            descriptor));
                }
                descriptor_ = descriptor;
            },
            "Write progress as lines of JSON to this file descriptor; 2 is standard error")
        ->type_name("FD")
        ->group(group);
}

void JsonProgress::write(const std::string& line)
{
    // One call, so that lines of several processes do not mix. The reader may be gone.
    std::ignore = ::write(descriptor_, line.data(), line.size());
}

void JsonProgress::show(const FillProgress& progress, const std::string& run)
{
    if (progress.pictures > 0)
    {
        show("drawing", progress.frames, progress.pictures, "frames", run);
    }
    else
    {
        show(progress.settles ? "settling" : "simulating", progress.spheres, progress.expected,
             "spheres", run);
    }
}

void JsonProgress::show(const char* stage, std::size_t done, std::size_t total, const char* unit,
                        const std::string& run)
{
    if (!wanted())
    {
        return;
    }
    total = std::max(total, done); // how many spheres fill an object is known roughly
    const Clock::time_point now = Clock::now();
    const std::string whole = stage + run;
    if (stage_ != whole)
    {
        stage_ = whole;
        began_ = now;
        first_ = done;
    }
    else if (seconds(now - shown_) < kSecondsPerObject)
    {
        return;
    }
    shown_ = now;
    const bool known = done > first_;
    const double eta = known ? seconds(now - began_) * static_cast<double>(total - done) /
                                   static_cast<double>(done - first_)
                             : 0;
    Json json = {{"stage", stage},
                 {"done", done},
                 {"total", total},
                 {"unit", unit},
                 {"eta_s", known ? Json(eta) : Json()}};
    if (!run.empty())
    {
        json["run"] = run;
    }
    write(json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

int JsonProgress::endWith(const std::function<int()>& work)
{
    if (wanted())
    {
        setExitLine(descriptor_, endLine(static_cast<int>(ErrorCode::stoppedEarly),
                                         "stopped before the run began; nothing was written"));
    }
    try
    {
        const int code = work();
        end(code, "");
        return code;
    }
    catch (...)
    {
        const Failure failure = currentFailure();
        end(static_cast<int>(failure.code), failure.message);
        throw;
    }
}

void JsonProgress::end(int code, const std::string& message)
{
    if (wanted())
    {
        write(endLine(code, message));
    }
}

} // namespace frostfill
