// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/rest.hpp"
#include "simulation/quality/contact_network.hpp"
#include "simulation/quality/equilibrium.hpp"

#include <cmath>
#include <vector>

namespace frostfill
{

/// Spheres and their contacts, put together by hand. Gravity pulls along -y.
class HandNetwork
{
public:
    /// `radius`: of the spheres that are not told another one. Places are in it.
    explicit HandNetwork(double radius = 1) : radius_(radius) {}

    HandNetwork& add(const Eigen::Vector3d& place, double radius = 1)
    {
        places_.push_back(place);
        network_.bodies.push_back({{0, -1, 0}, radius * radius_});
        return *this;
    }
    HandNetwork& push(std::uint32_t upon, std::uint32_t from, const Eigen::Vector3d& normal)
    {
        network_.contacts.push_back({normal, upon, from});
        return *this;
    }
    HandNetwork& touch(std::uint32_t a, std::uint32_t b)
    {
        return push(a, b, (places_[a] - places_[b]).normalized());
    }
    HandNetwork& wall(std::uint32_t body, const Eigen::Vector3d& normal)
    {
        return push(body, ContactNetwork::kWall, normal);
    }

    /// One on two or three that touch each other on a floor. It is the last.
    HandNetwork& pyramid(int below)
    {
        if (below == 2)
        {
            add({-1, 0, 0}).add({1, 0, 0}).add({0, std::sqrt(3.0), 0});
        }
        else
        {
            for (const Eigen::Vector3d& place : oracle::threeTouching(0))
            {
                add(place);
            }
            add({0, oracle::aboveThree(), 0});
        }
        touchAll();
        const auto count = static_cast<std::uint32_t>(below);
        for (std::uint32_t body = 0; body < count; ++body)
        {
            wall(body, {0, 1, 0});
        }
        return *this;
    }

    /// Layers of squares of touching spheres, as many as there are along a side, in a box that they
    /// just fill; every other layer is one smaller, in the hollows. Some are missing, from this
    /// number on.
    HandNetwork& box(int along, int firstMissing = 0, int missing = 0)
    {
        int number = 0;
        for (int layer = 0; layer < along; ++layer)
        {
            const int side = along - layer % 2;
            for (int k = 0; k < side * side; ++k)
            {
                const bool isThere = number < firstMissing || number >= firstMissing + missing;
                ++number;
                if (isThere)
                {
                    const double first = 1 - side;
                    add({first + 2 * (k % side), layer * std::sqrt(2.0), first + 2 * (k / side)});
                }
            }
        }
        touchAll();
        for (std::uint32_t body = 0; body < places_.size(); ++body)
        {
            const Eigen::Vector3d& p = places_[body];
            if (p.y() == 0)
            {
                wall(body, {0, 1, 0});
            }
            for (const int axis : {0, 2})
            {
                if (std::abs(p[axis]) == along - 1)
                {
                    wall(body, p[axis] > 0 ? -Eigen::Vector3d::Unit(axis)
                                           : Eigen::Vector3d(Eigen::Vector3d::Unit(axis)));
                }
            }
        }
        return *this;
    }

    [[nodiscard]] const ContactNetwork& network() const { return network_; }

private:
    void touchAll()
    {
        for (std::uint32_t a = 0; a < places_.size(); ++a)
        {
            for (std::uint32_t b = 0; b < a; ++b)
            {
                if ((places_[a] - places_[b]).norm() < 2 + 1e-9)
                {
                    touch(a, b);
                }
            }
        }
    }

    double radius_;
    std::vector<Eigen::Vector3d> places_;
    ContactNetwork network_;
};

inline constexpr double kFine = 1e-4; // [own weight] that may be missing where statics is exact

inline double leastFrictionOf(const ContactNetwork& network, std::size_t except = 0)
{
    Threads threads(1);
    return leastFriction(network, kFine, except, threads);
}

} // namespace frostfill
