// SPDX-License-Identifier: MIT
#include "image/png_bands.hpp"
#include "image/save_bytes.hpp"
#include "output/atomic_file.hpp"
#include "output/thinned_folder.hpp"

#include <frostfill/error.hpp>
#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <algorithm>
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

FrameThinning::Decision FrameThinning::take(std::size_t number)
{
    Decision decision;
    if (!wants(number))
    {
        return decision;
    }
    if (limit_ > 0 && count_ >= limit_)
    {
        decision.thin = true;
        count_ = (count_ + 1) / 2;
        stride_ *= 2;
    }
    decision.keep = wants(number) && (limit_ == 0 || count_ < limit_);
    count_ += decision.keep ? 1 : 0;
    return decision;
}

PngSequence::PngSequence(std::filesystem::path directory, std::size_t limit, PngText text)
    : directory_(std::move(directory)), thinning_(limit), text_(std::move(text)),
      encoder_(std::make_unique<PngBands>())
{
    createDirectory(directory_);
}

PngSequence::~PngSequence() = default;
PngSequence::PngSequence(PngSequence&&) noexcept = default;
PngSequence& PngSequence::operator=(PngSequence&&) noexcept = default;

std::string PngSequence::fileName(std::size_t index)
{
    return fmt::format("frame_{:05}.png", index);
}

void PngSequence::skip(std::size_t number)
{
    const std::size_t before = thinning_.count();
    if (thinning_.take(number).thin)
    {
        thin(before);
    }
}

std::filesystem::path PngSequence::file(std::size_t index) const
{
    return directory_ / fileName(index);
}

void PngSequence::put(std::size_t number, const Image& image)
{
    put(number, image, {}, {});
}

void PngSequence::put(std::size_t number, const Image& image,
                      std::span<const std::uint8_t> changedRows, const PngText& text)
{
    // The changes of a picture that is not kept count for the next one that is.
    changedRows_.resize(static_cast<std::size_t>(image.height), 1);
    for (std::size_t y = 0; y < changedRows_.size(); ++y)
    {
        changedRows_[y] |= y < changedRows.size() ? changedRows[y] : std::uint8_t{1};
    }

    const std::size_t before = thinning_.count();
    const FrameThinning::Decision decision = thinning_.take(number);
    if (decision.thin)
    {
        thin(before);
    }
    if (!decision.keep)
    {
        return;
    }

    const auto encoding = Clock::now();
    PngText all = text_;
    all.insert(all.end(), text.begin(), text.end());
    const std::vector<std::uint8_t>& bytes = encoder_->encode(image, all, changedRows_);
    std::fill(changedRows_.begin(), changedRows_.end(), std::uint8_t{0});
    times_[Stage::encoding] += secondsSince(encoding);

    const auto writing = Clock::now();
    saveBytes(bytes, file(thinning_.count() - 1));
    times_[Stage::writing] += secondsSince(writing);
}

void PngSequence::thin(std::size_t count)
{
    const auto start = Clock::now();
    const std::error_code error = keepEverySecond(directory_, count, &fileName);
    if (error)
    {
        throw Error(ErrorCode::writeFailed, fmt::format("cannot thin out the frames in {}: {}",
                                                        directory_.string(), error.message()));
    }
    times_[Stage::writing] += secondsSince(start);
}

} // namespace frostfill
