// SPDX-License-Identifier: MIT
#include "lab/operations.hpp"

#include <frostfill/mesh.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

Scene sceneOf(const OperationsCase& what, const MeshReport& mesh)
{
    Scene scene = presetScene(Preset::paper, what.object);
    scene.spheres.groupSize = static_cast<std::uint32_t>(what.gamma);
    scene.spheres.groupsPerSet = static_cast<std::uint32_t>(what.k);
    scene.spheres.count = what.gamma * std::max(what.groups, what.room);
    scene.spheres.radius = Radii(sphereRadius(scene, mesh));
    scene.spheres.count = what.gamma * what.groups;
    scene.freezing.everySets = 1;
    scene.discard.rule = what.discards ? DiscardRule::paper : DiscardRule::none;
    scene.search = {SphereSearch::allPairs, PolygonSearch::loop};
    return scene;
}

/// Follows a run set by set.
class OperationsWatch
{
public:
    OperationsWatch(const OperationsCase& what, std::uint64_t polygons)
        : what_(what), polygons_(polygons)
    {
    }

    void observe(const Simulation& simulation)
    {
        if (rows_.size() < simulation.sets().size())
        {
            openSet(simulation);
        }
        const OperationCounts made = simulation.operations() - before_;
        before_ = simulation.operations();
        OperationsRow& row = rows_.back();
        const std::uint64_t tests = made.runningRunningTests + made.runningFrozenTests;
        const std::uint64_t responses = made.runningRunningResponses + made.runningFrozenResponses;
        if (steps_ == 0)
        {
            row.sphereTests = tests;
            row.polygonTests = made.spherePolygonTests;
            row.polygonTestsSoFar += made.spherePolygonTests;
        }
        row.constant =
            row.constant && tests == row.sphereTests && made.spherePolygonTests == row.polygonTests;
        row.greatestSphereResponses = std::max(row.greatestSphereResponses, responses);
        row.greatestPolygonResponses =
            std::max(row.greatestPolygonResponses, made.spherePolygonResponses);
        ++steps_;
        responses_ += responses;
        row.meanSphereResponses = static_cast<double>(responses_) / static_cast<double>(steps_);
    }

    [[nodiscard]] std::vector<OperationsRow> take() { return std::move(rows_); }

private:
    void openSet(const Simulation& simulation)
    {
        simulation.capture(snapshot_);
        OperationsRow row;
        row.polygonTestsSoFar = rows_.empty() ? 0 : rows_.back().polygonTestsSoFar;
        row.beta = snapshot_.centres.size() / what_.gamma;
        row.alpha = snapshot_.discarded / what_.gamma;
        row.polygons = polygons_ - snapshot_.discardedPolygons;
        row.spheres = what_.k == 1 ? lemma1(row.beta, what_.gamma, row.alpha)
                                   : lemma2(row.beta, what_.gamma, what_.k, row.alpha);
        if (!rows_.empty())
        {
            discardedAfter_.back() = rows_.back().polygons - row.polygons;
        }
        discardedAfter_.push_back(0);
        row.polygonsSoFar = lemma3(what_.gamma, what_.k, polygons_, discardedAfter_);
        row.withoutFreezing = bruteForce(snapshot_.centres.size());
        rows_.push_back(row);
        steps_ = 0;
        responses_ = 0;
    }

    OperationsCase what_;
    std::uint64_t polygons_;
    std::vector<OperationsRow> rows_;
    std::vector<std::uint64_t> discardedAfter_; ///< polygons, by set
    Snapshot snapshot_;
    OperationCounts before_;
    std::uint64_t steps_ = 0; ///< of the newest set
    std::uint64_t responses_ = 0;
};

} // namespace

Operations bruteForce(std::uint64_t spheres)
{
    const std::uint64_t ordered = spheres > 0 ? spheres * (spheres - 1) : 0;
    return {ordered / 2, ordered};
}

Operations lemma1(std::uint64_t beta, std::uint64_t gamma, std::uint64_t alpha)
{
    return lemma2(beta, gamma, 1, alpha);
}

Operations lemma2(std::uint64_t beta, std::uint64_t gamma, std::uint64_t k, std::uint64_t alpha)
{
    const std::uint64_t running = k * gamma;
    const std::uint64_t withFrozen = (beta - k - alpha) * gamma * running;
    const Operations among = bruteForce(running);
    return {withFrozen + among.tests, withFrozen + among.responses};
}

Operations lemma3(std::uint64_t gamma, std::uint64_t k, std::uint64_t m,
                  std::span<const std::uint64_t> discardedAfter)
{
    std::uint64_t left = m;
    std::uint64_t tests = 0;
    for (const std::uint64_t discarded : discardedAfter)
    {
        tests += k * gamma * left;
        left -= discarded;
    }
    return {tests, tests};
}

bool OperationsRow::agrees() const
{
    return constant && sphereTests == spheres.tests &&
           greatestSphereResponses <= spheres.responses &&
           polygonTestsSoFar == polygonsSoFar.tests && greatestPolygonResponses <= polygonTests;
}

OperationsResult measureOperations(const OperationsCase& what)
{
    const LoadedMesh loaded = loadMesh(what.object);
    const TriangleMesh& mesh = loaded.mesh;
    OperationsResult result;
    result.what = what;
    result.polygons = mesh.triangles.size();
    Simulation simulation(sceneOf(what, loaded.report), mesh);
    OperationsWatch watch(what, result.polygons);
    while (simulation.step())
    {
        watch.observe(simulation);
    }
    result.rows = watch.take();
    return result;
}

Table operationsCsv(const std::vector<OperationsResult>& results)
{
    Table table;
    table.headings = {"object",
                      "gamma",
                      "k",
                      "discards",
                      "beta",
                      "alpha",
                      "spheres",
                      "sphere_tests",
                      "sphere_tests_lemma",
                      "sphere_responses_mean",
                      "sphere_responses_greatest",
                      "sphere_responses_lemma",
                      "tests_without_freezing",
                      "polygons",
                      "polygon_tests",
                      "polygon_tests_so_far",
                      "polygon_tests_so_far_lemma",
                      "polygon_responses_greatest",
                      "agrees"};
    for (const OperationsResult& result : results)
    {
        for (const OperationsRow& row : result.rows)
        {
            std::vector<std::string> cells = {result.what.object};
            for (const std::uint64_t number :
                 {result.what.gamma, result.what.k, std::uint64_t{result.what.discards}, row.beta,
                  row.alpha, row.beta * result.what.gamma, row.sphereTests, row.spheres.tests})
            {
                cells.push_back(fmt::format("{}", number));
            }
            cells.push_back(fmt::format("{:.6g}", row.meanSphereResponses));
            for (const std::uint64_t number :
                 {row.greatestSphereResponses, row.spheres.responses, row.withoutFreezing.tests,
                  row.polygons, row.polygonTests, row.polygonTestsSoFar, row.polygonsSoFar.tests,
                  row.greatestPolygonResponses, std::uint64_t{row.agrees()}})
            {
                cells.push_back(fmt::format("{}", number));
            }
            table.rows.push_back(cells);
        }
    }
    return table;
}

} // namespace frostfill
