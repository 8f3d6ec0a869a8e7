// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "base/timers.hpp"
#include "image/png_bands.hpp"

#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace frostfill
{

std::string numberedName(std::string_view what, std::size_t frame, std::string_view ending)
{
    return fmt::format("{}_{:05}.{}", what, frame, ending);
}

PngSequence::PngSequence(std::filesystem::path directory, PngText text)
    : directory_(std::move(directory)), text_(std::move(text)),
      encoder_(std::make_unique<PngBands>())
{
    createDirectory(directory_);
}

PngSequence::~PngSequence() = default;
PngSequence::PngSequence(PngSequence&&) noexcept = default;
PngSequence& PngSequence::operator=(PngSequence&&) noexcept = default;

std::string PngSequence::fileName(std::size_t frame)
{
    return numberedName("frame", frame, "png");
}

std::string_view PngSequence::endingOf(std::string_view name)
{
    constexpr std::string_view kPrefix = "frame_";
    constexpr std::size_t kDigits = 5;
    const std::size_t end =
        std::min(name.find_first_not_of("0123456789", kPrefix.size()), name.size());
    return name.starts_with(kPrefix) && end >= kPrefix.size() + kDigits ? name.substr(end)
                                                                        : std::string_view();
}

void PngSequence::put(std::size_t frame, const Image& image)
{
    put(frame, image, {}, {});
}

void PngSequence::put(std::size_t frame, const Image& image,
                      std::span<const std::uint8_t> changedRows, const PngText& text)
{
    const std::vector<std::uint8_t>* bytes = nullptr;
    {
        const StageTimer timer(times_, Stage::encoding);
        PngText all = text_;
        all.insert(all.end(), text.begin(), text.end());
        std::vector<std::uint8_t> rows(changedRows.begin(), changedRows.end());
        rows.resize(static_cast<std::size_t>(image.height), 1);
        bytes = &encoder_->encode(image, all, rows);
    }
    const StageTimer timer(times_, Stage::writing);
    saveBytes(*bytes, directory_ / fileName(frame));
}

} // namespace frostfill
