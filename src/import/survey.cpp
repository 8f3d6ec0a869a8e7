// SPDX-License-Identifier: MIT
#include "import/survey.hpp"

#include "import/moment_sequence.hpp"

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

void follow(const Moment& moment, std::size_t step, Survey& survey)
{
    bool appeared = false;
    for (std::size_t k = 0; k < moment.centres.size(); ++k)
    {
        const auto [at, isNew] = survey.lives.try_emplace(moment.ids[k]);
        Life& life = at->second;
        const Eigen::Vector3d& place = moment.centres[k];
        if (isNew || (place - life.place).norm() > kRestsWithin * moment.radii[k])
        {
            life.place = place;
            life.restsSince = step;
        }
        if (isNew)
        {
            life.group = survey.groups;
            appeared = true;
        }
        if (!moment.groups.empty())
        {
            life.group = moment.groups[k];
        }
        life.lastStep = step;
        survey.smallestRadius = survey.smallestRadius > 0
                                    ? std::min(survey.smallestRadius, moment.radii[k])
                                    : moment.radii[k];
        survey.largestRadius = std::max(survey.largestRadius, moment.radii[k]);
    }
    survey.groups += appeared ? 1 : 0;
}

} // namespace

Survey surveyMoments(const ImportRequest& request)
{
    MomentSequence sequence(request);
    Survey survey;
    for (Moment moment; sequence.next(moment);)
    {
        survey.times.push_back(sequence.time());
        follow(moment, sequence.index(), survey);
        if (moment.box && !survey.box)
        {
            survey.box.emplace(*moment.box);
        }
        else if (moment.box)
        {
            survey.box->extend(*moment.box);
        }
        survey.statesGiven = survey.statesGiven || !moment.states.empty();
        survey.spheres = moment.centres.size();
        if (moment.centres.empty())
        {
            continue;
        }
        std::erase_if(survey.columns,
                      [&](const ColumnValues& values)
                      {
                          const Column& column = values.column();
                          return !column.compute && !moment.carried.contains(&column);
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
