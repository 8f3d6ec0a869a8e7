// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Velocities by sphere. What is at rest has none, and most of a run's spheres are: they are kept
/// in pages, and a page goes as soon as nothing on it moves.
class Velocities
{
public:
    [[nodiscard]] Eigen::Vector3d operator[](std::size_t id) const
    {
        const std::size_t page = id / kOnPage;
        return page < pages_.size() && !pages_[page].values.empty()
                   ? pages_[page].values[id % kOnPage]
                   : Eigen::Vector3d(Eigen::Vector3d::Zero());
    }

    /// The sphere moves from now on, first with velocity zero.
    void start(std::size_t id)
    {
        const std::size_t page = id / kOnPage;
        if (page >= pages_.size())
        {
            pages_.resize(page + 1);
        }
        ++pages_[page].moving;
    }

    /// `id` moves.
    void set(std::size_t id, const Eigen::Vector3d& velocity)
    {
        Page& page = pages_[id / kOnPage];
        if (page.values.empty())
        {
            page.values.assign(kOnPage, Eigen::Vector3d::Zero());
        }
        page.values[id % kOnPage] = velocity;
    }

    /// The sphere that moved is at rest, or gone.
    void stop(std::size_t id)
    {
        Page& page = pages_[id / kOnPage];
        if (!page.values.empty())
        {
            page.values[id % kOnPage].setZero();
        }
        if (--page.moving == 0)
        {
            std::vector<Eigen::Vector3d>().swap(page.values); // gives the memory back
        }
    }

private:
    static constexpr std::size_t kOnPage = 256;
    struct Page
    {
        std::uint32_t moving = 0;
        std::vector<Eigen::Vector3d> values; ///< empty: all are zero
    };
    std::vector<Page> pages_;
};

} // namespace frostfill
