// SPDX-License-Identifier: MIT
#include "import/moment_sequence.hpp"

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

MomentSequence::MomentSequence(const ImportRequest& request)
    : request_(request), reader_(request.file, request.radius.value_or(0))
{
}

double MomentSequence::timeOf(const Moment& moment) const
{
    if (request_.timeStep)
    {
        const auto steps = static_cast<double>(moment.step.value_or(count_));
        return steps * *request_.timeStep;
    }
    if (!moment.time && count_ > 0)
    {
        refuse(request_, ErrorCode::usage,
               "has several steps and no times: give the seconds between two steps with "
               "--timestep");
    }
    return moment.time.value_or(0);
}

// Without ids, the order of the lines is all there is. XYZ keeps it; parallel dumps do not.
void MomentSequence::nameSpheres(Moment& moment) const
{
    if (!moment.ids.empty() || moment.centres.empty())
    {
        return;
    }
    if (reader_.isDump() && count_ > 0)
    {
        refuse(request_, ErrorCode::badData,
               "has several steps but no column id, which tells the spheres apart; dump id too");
    }
    moment.ids.resize(moment.centres.size());
    std::iota(moment.ids.begin(), moment.ids.end(), std::uint64_t{1});
}

bool MomentSequence::next(Moment& moment)
{
    while (reader_.next(moment))
    {
        if (count_ > 0 && moment.step && step_ && *moment.step == *step_)
        {
            ++repeats_;
            continue;
        }
        nameSpheres(moment);
        const double time = timeOf(moment);
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
        step_ = moment.step;
        ++count_;
        return true;
    }
    return false;
}

} // namespace frostfill
