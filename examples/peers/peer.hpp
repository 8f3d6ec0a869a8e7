// SPDX-License-Identifier: MIT
// The protocol of `frostfill-lab peers`, for engines in C++. docs/accuracy.md describes it. Lengths
// are in radii of the spheres, times in sqrt(r/g); down is -y.
#pragma once

#include <array>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

struct Task
{
    double restitution = 0;
    double friction = 0;
    double step = 0;
    double bounce = 0; ///< slower impacts may end without a bounce
    double still = 0;  ///< slower spheres may sleep
    std::size_t spheres = 0;
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<unsigned, 3>> triangles;
};

template <typename Row>
void readRows(std::vector<Row>& rows)
{
    std::size_t count = 0;
    std::cin >> count;
    rows.resize(count);
    for (Row& row : rows)
    {
        std::cin >> row[0] >> row[1] >> row[2];
    }
}

/// What stands before `start`.
inline Task readTask()
{
    Task task;
    for (std::string word; std::cin >> word && word != "start";)
    {
        if (word == "frostfill-peer")
        {
            int version = 0;
            std::cin >> version;
        }
        else if (word == "restitution")
        {
            std::cin >> task.restitution;
        }
        else if (word == "friction")
        {
            std::cin >> task.friction;
        }
        else if (word == "step")
        {
            std::cin >> task.step;
        }
        else if (word == "bounce")
        {
            std::cin >> task.bounce;
        }
        else if (word == "still")
        {
            std::cin >> task.still;
        }
        else if (word == "spheres")
        {
            std::cin >> task.spheres;
        }
        else if (word == "vertices")
        {
            readRows(task.vertices);
        }
        else if (word == "triangles")
        {
            readRows(task.triangles);
        }
    }
    return task;
}

/// Does what it is told until the end. `Engine` has add(place), step() and places().
template <typename Engine>
int servePeer()
{
    std::ios::sync_with_stdio(false);
    const Task task = readTask();
    Engine engine(task);
    std::puts("ready");
    std::fflush(stdout);
    for (std::string word; std::cin >> word && word != "end";)
    {
        if (word == "add")
        {
            std::array<double, 3> place{};
            std::cin >> place[0] >> place[1] >> place[2];
            engine.add(place);
        }
        else if (word == "step")
        {
            engine.step();
        }
        else if (word == "places")
        {
            const std::vector<std::array<double, 3>> places = engine.places();
            std::printf("places %zu\n", places.size());
            for (const auto& place : places)
            {
                std::printf("%.17g %.17g %.17g\n", place[0], place[1], place[2]);
            }
            std::fflush(stdout);
        }
    }
    return 0;
}
