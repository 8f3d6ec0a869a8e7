// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/reach/voxel_layout.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace frostfill
{

/// A set of cubes of which there are few, side by side: memory only where there are some.
class SparseVoxelBits
{
public:
    SparseVoxelBits() = default;
    explicit SparseVoxelBits(std::size_t words)
        : count_((words + kWordsOfBlock - 1) / kWordsOfBlock),
          blocks_(std::make_unique<std::atomic<Block*>[]>(count_))
    {
    }
    ~SparseVoxelBits() { clear(); }
    SparseVoxelBits(SparseVoxelBits&& other) noexcept
        : count_(std::exchange(other.count_, 0)), blocks_(std::move(other.blocks_))
    {
    }
    SparseVoxelBits& operator=(SparseVoxelBits&& other) noexcept
    {
        std::swap(count_, other.count_);
        std::swap(blocks_, other.blocks_);
        return *this;
    }

    [[nodiscard]] std::uint64_t operator[](std::size_t word) const
    {
        Block* const block = blocks_[word / kWordsOfBlock].load(std::memory_order_acquire);
        return block == nullptr ? 0 : at(*block, word).load(std::memory_order_relaxed);
    }
    /// Adds cubes of a word that no other thread asks for. Returns what it had before.
    std::uint64_t add(VoxelWord cubes)
    {
        const auto word = at(obtain(cubes.word), cubes.word);
        const std::uint64_t before = word.load(std::memory_order_relaxed);
        word.store(before | cubes.bits, std::memory_order_relaxed);
        return before;
    }
    /// The same of a word to which others may add at the same time.
    std::uint64_t addShared(VoxelWord cubes)
    {
        return at(obtain(cubes.word), cubes.word).fetch_or(cubes.bits, std::memory_order_relaxed);
    }
    /// Takes all out, on one thread.
    void clear()
    {
        for (std::size_t k = 0; k < count_; ++k)
        {
            delete blocks_[k].exchange(nullptr, std::memory_order_relaxed);
        }
    }

private:
    /// Larger: memory for cubes that are not in the set. Smaller: for pointers.
    static constexpr std::size_t kWordsOfBlock = 64;
    struct Block
    {
        std::uint64_t words[kWordsOfBlock] = {};
    };

    [[nodiscard]] static std::atomic_ref<std::uint64_t> at(Block& block, std::size_t word)
    {
        return std::atomic_ref(block.words[word % kWordsOfBlock]);
    }
    Block& obtain(std::size_t word)
    {
        std::atomic<Block*>& place = blocks_[word / kWordsOfBlock];
        Block* block = place.load(std::memory_order_acquire);
        if (block == nullptr)
        {
            auto fresh = std::make_unique<Block>();
            if (place.compare_exchange_strong(block, fresh.get(), std::memory_order_acq_rel,
                                              std::memory_order_acquire))
            {
                block = fresh.release();
            }
        }
        return *block;
    }

    std::size_t count_ = 0;
    std::unique_ptr<std::atomic<Block*>[]> blocks_;
};

} // namespace frostfill
