// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace frostfill
{

/// What a column does when rows come, move and go.
class RowFollower
{
public:
    virtual ~RowFollower() = default;
    /// There are at least so many rows.
    virtual void fit(std::uint32_t rows) = 0;
    /// The sphere of this row begins to run, or begins anew elsewhere.
    virtual void start(std::uint32_t row) = 0;
    virtual void swap(std::uint32_t a, std::uint32_t b) = 0;
};

/// The rows of running spheres, and the columns that follow them. Only Spheres adds and removes
/// rows.
class RunningRows
{
public:
    RunningRows() = default;
    RunningRows(const RunningRows&) = delete;
    RunningRows& operator=(const RunningRows&) = delete;

    [[nodiscard]] std::uint32_t size() const { return rows_; }

protected:
    template <class T>
    friend class RunningColumn;

    std::vector<RowFollower*> columns_;
    std::uint32_t rows_ = 0;
};

/// A value for each running sphere, kept by the part that declares it. To declare it is all: it
/// follows the rows from then on. Rows that are gone keep their value, and so its memory, for those
/// to come.
template <class T>
class RunningColumn final : private RowFollower
{
public:
    /// Sets the value of a row whose sphere begins to run. The table's own columns are set by then.
    using Start = std::function<void(std::uint32_t row, T& value)>;

    explicit RunningColumn(RunningRows& rows, Start start = {})
        : rows_(rows), start_(std::move(start))
    {
        rows_.columns_.push_back(this);
        RunningColumn::fit(rows_.size());
        for (std::uint32_t row = 0; row < rows_.size(); ++row)
        {
            RunningColumn::start(row);
        }
    }
    ~RunningColumn() override { std::erase(rows_.columns_, static_cast<RowFollower*>(this)); }
    RunningColumn(const RunningColumn&) = delete;
    RunningColumn& operator=(const RunningColumn&) = delete;

    [[nodiscard]] T& operator[](std::uint32_t row) { return values_[row]; }
    [[nodiscard]] const T& operator[](std::uint32_t row) const { return values_[row]; }
    [[nodiscard]] std::span<T> all() { return {values_.data(), rows_.size()}; }
    [[nodiscard]] std::span<const T> all() const { return {values_.data(), rows_.size()}; }

private:
    void fit(std::uint32_t rows) override
    {
        values_.resize(std::max<std::size_t>(values_.size(), rows));
    }
    void start(std::uint32_t row) override
    {
        if (start_)
        {
            start_(row, (*this)[row]);
        }
    }
    void swap(std::uint32_t a, std::uint32_t b) override { std::swap(values_[a], values_[b]); }

    RunningRows& rows_;
    std::vector<T> values_;
    Start start_;
};

/// The running part of the table of spheres, by row: the only home of where they are and how fast.
struct RunningSpheres : RunningRows
{
    static constexpr std::uint32_t kNoSphere = 0xffffffff; ///< id in a row whose sphere is gone

    RunningColumn<std::uint32_t> id{*this};
    RunningColumn<Eigen::Vector3d> position{*this};
    RunningColumn<Eigen::Vector3d> velocity{*this};
    RunningColumn<double> radius{*this};

    /// See Spheres::closeRanks.
    [[nodiscard]] bool isGone(std::uint32_t row) const { return id[row] == kNoSphere; }
    /// Lets the sphere begin anew elsewhere, without speed.
    void restart(std::uint32_t row, const Eigen::Vector3d& place)
    {
        position[row] = place;
        velocity[row].setZero();
        for (RowFollower* column : columns_)
        {
            column->start(row);
        }
    }

private:
    friend class Spheres;
};

} // namespace frostfill
