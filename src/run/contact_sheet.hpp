// SPDX-License-Identifier: MIT
#pragma once

#include "run/frame_painter.hpp"

#include <frostfill/image.hpp>
#include <frostfill/renderer.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace frostfill
{

/// The part of a picture that a contact sheet shows [pixel].
struct Crop
{
    int left = 0, top = 0, right = 0, bottom = 0;
};

struct ContactSheetRequest
{
    std::filesystem::path frames;     ///< directory of a PngSequence
    std::vector<std::size_t> numbers; ///< of the frames in it
    std::vector<double> times;        ///< [frames] simulated, for the captions [s]
    std::string title;
    Palette palette;
    Crop crop; ///< what is shown of each
};

/// Up to twelve frames at equal steps, first and last among them, each over the time it shows.
/// Throws Error inputMissing or badData when a frame cannot be read.
[[nodiscard]] Image makeContactSheet(const ContactSheetRequest& request);

/// Writes contact_sheet.png beside the pictures that the painter has drawn for a run. Throws Error.
void writeContactSheet(const Scene& scene, const std::filesystem::path& directory,
                       const FramePainter& painter);

} // namespace frostfill
