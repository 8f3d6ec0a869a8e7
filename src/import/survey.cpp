// SPDX-License-Identifier: MIT
#include "import/survey.hpp"

#include "import/timestep_sequence.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// A sphere that stays within this of a place rests there [r]. Larger: what creeps counts as at
/// rest. Smaller: what trembles in its contacts, as in most discrete-element codes, never does.
constexpr double kRestsWithin = 1e-3;

void follow(const Timestep& timestep, std::size_t step, Survey& survey)
{
    bool appeared = false;
    for (std::size_t k = 0; k < timestep.centres.size(); ++k)
    {
        const auto [at, isNew] = survey.lives.try_emplace(timestep.ids[k]);
        Life& life = at->second;
        const Eigen::Vector3d& place = timestep.centres[k];
        if (isNew || (place - life.place).norm() > kRestsWithin * timestep.radii[k])
        {
            life.place = place;
            life.restsSince = step;
        }
        if (isNew)
        {
            life.group = survey.groups;
            appeared = true;
        }
        if (!timestep.groups.empty())
        {
            life.group = timestep.groups[k];
        }
        life.lastStep = step;
        survey.smallestRadius = survey.smallestRadius > 0
                                    ? std::min(survey.smallestRadius, timestep.radii[k])
                                    : timestep.radii[k];
        survey.largestRadius = std::max(survey.largestRadius, timestep.radii[k]);
    }
    survey.groups += appeared ? 1 : 0;
}

} // namespace

Survey surveyTimesteps(const ImportRequest& request)
{
    TimestepSequence sequence(request);
    Survey survey;
    for (Timestep timestep; sequence.next(timestep);)
    {
        survey.times.push_back(sequence.time());
        follow(timestep, sequence.index(), survey);
        if (timestep.box && !survey.box)
        {
            survey.box.emplace(*timestep.box);
        }
        else if (timestep.box)
        {
            survey.box->extend(*timestep.box);
        }
        survey.statesGiven = survey.statesGiven || !timestep.states.empty();
        survey.spheres = timestep.centres.size();
        if (timestep.centres.empty())
        {
            continue;
        }
        std::erase_if(survey.columns,
                      [&](const ColumnValues& values)
                      {
                          const Column& column = values.column();
                          return !column.compute && !timestep.carried.contains(&column);
                      });
    }
    survey.torn = sequence.reader().torn();
    survey.format = sequence.reader().format();
    survey.repeats = sequence.repeats();
    survey.vanished = survey.lives.size() - survey.spheres;
    for (const auto& [id, life] : survey.lives)
    {
        survey.groups = std::max(survey.groups, life.group + 1);
    }
    if (survey.lives.empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' has no whole step with a sphere{}{}", request.file.string(),
                                survey.torn.empty() ? "" : ": ", survey.torn));
    }
    return survey;
}

} // namespace frostfill
