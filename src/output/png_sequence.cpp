// SPDX-License-Identifier: MIT
#include "output/atomic_file.hpp"

#include <frostfill/error.hpp>
#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace frostfill
{
namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

PngSequence::PngSequence(std::filesystem::path directory, std::size_t limit, PngText text)
    : directory_(std::move(directory)), limit_(limit), text_(std::move(text))
{
    createDirectory(directory_);
}

std::filesystem::path PngSequence::file(std::size_t index) const
{
    return directory_ / fmt::format("frame_{:05}.png", index);
}

void PngSequence::put(std::size_t number, const Image& image)
{
    if (!wants(number))
        return;
    if (limit_ > 0 && count_ >= limit_)
        thin();
    if (!wants(number) || (limit_ > 0 && count_ >= limit_))
        return;

    const auto start = Clock::now();
    savePng(image, file(count_), text_);
    times_[Stage::encoding] += secondsSince(start);
    ++count_;
}

void PngSequence::thin()
{
    const auto start = Clock::now();
    std::error_code error;
    for (std::size_t index = 1; index < count_ && !error; ++index)
    {
        if (index % 2 == 1)
            std::filesystem::remove(file(index), error);
        else
            std::filesystem::rename(file(index), file(index / 2), error);
    }
    if (error)
        throw Error(ErrorCode::writeFailed, fmt::format("cannot thin out the frames in {}: {}",
                                                        directory_.string(), error.message()));
    count_ = (count_ + 1) / 2;
    stride_ *= 2;
    times_[Stage::writing] += secondsSince(start);
}

} // namespace frostfill
