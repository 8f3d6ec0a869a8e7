// SPDX-License-Identifier: MIT
#include "import/timestep_sequence.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

[[noreturn]] void refuse(const ImportRequest& request, ErrorCode code, const std::string& what)
{
    throw Error(code, fmt::format("'{}' {}", request.file.string(), what));
}

} // namespace

TimestepSequence::TimestepSequence(const ImportRequest& request)
    : request_(request), reader_(request.file, request.radius.value_or(0))
{
}

double TimestepSequence::timeOf(const Timestep& timestep) const
{
    if (request_.timeStep)
    {
        const auto steps = static_cast<double>(timestep.step.value_or(count_));
        return steps * *request_.timeStep;
    }
    if (!timestep.time && count_ > 0)
    {
        refuse(request_, ErrorCode::usage,
               "has several steps and no times: give the seconds between two steps with "
               "--timestep");
    }
    return timestep.time.value_or(0);
}

// Without ids, the order of the lines is all there is. XYZ keeps it; parallel dumps do not.
void TimestepSequence::nameSpheres(Timestep& timestep) const
{
    if (!timestep.ids.empty() || timestep.centres.empty())
    {
        return;
    }
    if (reader_.isDump() && count_ > 0)
    {
        refuse(request_, ErrorCode::badData,
               "has several steps but no column id, which tells the spheres apart; dump id too");
    }
    timestep.ids.resize(timestep.centres.size());
    std::iota(timestep.ids.begin(), timestep.ids.end(), std::uint64_t{1});
}

bool TimestepSequence::next(Timestep& timestep)
{
    while (reader_.next(timestep))
    {
        if (count_ > 0 && timestep.step && step_ && *timestep.step == *step_)
        {
            ++repeats_;
            continue;
        }
        nameSpheres(timestep);
        const double time = timeOf(timestep);
        if (!std::isfinite(time))
        {
            refuse(request_, ErrorCode::badData,
                   fmt::format("has a step whose time is not a number, behind {} s", time_));
        }
        if (count_ > 0 && time < time_)
        {
            refuse(request_, ErrorCode::badData,
                   fmt::format("goes back in time, from {} s to {} s: it holds several runs; "
                               "import them one by one",
                               time_, time));
        }
        time_ = time;
        step_ = timestep.step;
        ++count_;
        return true;
    }
    return false;
}

} // namespace frostfill
