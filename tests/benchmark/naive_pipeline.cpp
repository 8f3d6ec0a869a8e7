// SPDX-License-Identifier: MIT
#include "benchmark/naive_pipeline.hpp"

// As it comes: its own deflate, its own choice of filters, and a copy of its own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace frostfill::benchmark
{

NaivePipeline::NaivePipeline(PictureSize size, int samples) : spheres_(size, samples, 1, 2, 1)
{
}

void NaivePipeline::save(const Image& image, const std::filesystem::path& file)
{
    stbi_write_png(file.c_str(), image.width, image.height, image.channels, image.pixels.data(),
                   image.width * image.channels);
}

} // namespace frostfill::benchmark
