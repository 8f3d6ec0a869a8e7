// SPDX-License-Identifier: MIT
#include "image/png_bands.hpp"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <latch>
#include <thread>

namespace frostfill
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

/// Short data, as of small pictures, with runs of equal bytes from the second place on.
Bytes shortData(int seed)
{
    Bytes data(static_cast<std::size_t>(100 + 7 * seed), static_cast<std::uint8_t>(seed));
    data[0] = 2;
    for (std::size_t i = 25; i < data.size(); ++i)
    {
        data[i] = static_cast<std::uint8_t>(i % 25 == 0 ? 2 : 0);
    }
    return data;
}

/// As of a band of a picture of which most is one colour.
Bytes sparseData(std::uint32_t seed)
{
    Bytes data(12000);
    data[0] = 2;
    for (std::size_t i = 9000; i + 200 < data.size(); i += 211)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            seed = seed * 1664525 + 1013904223;
            data[i + k] = static_cast<std::uint8_t>(seed >> 24);
        }
    }
    return data;
}

Bytes deflatedAll()
{
    Bytes all;
    for (std::uint32_t seed = 0; seed < 800; ++seed)
    {
        deflateBand(sparseData(seed), all);
    }
    for (int seed = 0; seed < 100; ++seed)
    {
        deflateBand(shortData(seed), all);
    }
    return all;
}

// Every thread has its memory elsewhere, as every run has.
TEST(DeflateBand, GivesTheSameBytesWhereverItsMemoryLies)
{
    constexpr std::ptrdiff_t kThreads = 60;
    std::latch all(kThreads); // so that none takes the memory of one that has ended
    std::vector<Bytes> bytes(kThreads);
    std::vector<std::thread> threads;
    threads.reserve(bytes.size());
    for (Bytes& own : bytes)
    {
        threads.emplace_back(
            [&]
            {
                own = deflatedAll();
                all.arrive_and_wait();
            });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    for (const Bytes& own : bytes)
    {
        EXPECT_EQ(own, bytes.front());
    }
}

TEST(DeflateBand, IsReadByAnotherLibrary)
{
    for (int seed = 0; seed < 100; ++seed)
    {
        const Bytes data = shortData(seed);
        Bytes stream;
        deflateBand(data, stream);
        stream.insert(stream.end(), {0x03, 0x00}); // an empty last block
        Bytes back(data.size());
        libdeflate_decompressor* reader = libdeflate_alloc_decompressor();
        EXPECT_EQ(libdeflate_deflate_decompress(reader, stream.data(), stream.size(), back.data(),
                                                back.size(), nullptr),
                  LIBDEFLATE_SUCCESS);
        libdeflate_free_decompressor(reader);
        EXPECT_EQ(back, data) << seed;
    }
}

} // namespace
} // namespace frostfill
