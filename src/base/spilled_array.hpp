// SPDX-License-Identifier: MIT
#pragma once

#include "base/spilled_bytes.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace frostfill
{

/// An array as std::vector is one, whose bytes leave memory when it is large: see SpilledBytes.
template <class T>
class SpilledArray
{
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);

public:
    /// In memory up to so many.
    explicit SpilledArray(std::size_t inMemory = SpilledBytes::kInMemory / sizeof(T))
        : bytes_(std::min(inMemory, kMost) * sizeof(T))
    {
    }
    SpilledArray(SpilledArray&& other) noexcept
        : bytes_(std::move(other.bytes_)), data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0)), room_(std::exchange(other.room_, 0))
    {
    }
    SpilledArray& operator=(SpilledArray&& other) noexcept
    {
        bytes_ = std::move(other.bytes_);
        data_ = std::exchange(other.data_, nullptr);
        size_ = std::exchange(other.size_, 0);
        room_ = std::exchange(other.room_, 0);
        return *this;
    }
    ~SpilledArray() = default;

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
    [[nodiscard]] T* begin() { return data_; }
    [[nodiscard]] T* end() { return data_ + size_; }
    [[nodiscard]] const T* begin() const { return data_; }
    [[nodiscard]] const T* end() const { return data_ + size_; }

    void pushBack(const T& value)
    {
        if (size_ == room_) [[unlikely]]
        {
            const T one = value; // which may be one of these, and move
            makeRoom(size_ + 1);
            data_[size_++] = one;
            return;
        }
        data_[size_++] = value;
    }
    void popBack() { --size_; }
    void resize(std::size_t size, const T& value)
    {
        makeRoom(size);
        std::fill(data_ + std::min(size, size_), data_ + size, value);
        size_ = size;
    }
    /// Room for so many without moving any, as far as they stay in memory. A file grows without
    /// copies.
    void reserve(std::size_t count) { makeRoom(std::min(count, bytes_.inMemory() / sizeof(T))); }

    /// Gives back memory that is not in use, but none of a file, which has left.
    void shrinkToFit()
    {
        if (!isInFile())
        {
            SpilledArray fitted(bytes_.inMemory() / sizeof(T));
            fitted.makeRoom(size_);
            std::copy(begin(), end(), fitted.begin());
            fitted.size_ = size_;
            *this = std::move(fitted);
        }
    }

    [[nodiscard]] bool isInFile() const { return bytes_.isInFile(); }
    /// What is in a file leaves memory until it is looked at again.
    void leave() const { bytes_.leave(); }

private:
    [[gnu::noinline]] void makeRoom(std::size_t count)
    {
        bytes_.grow(size_ * sizeof(T), count * sizeof(T));
        data_ = static_cast<T*>(bytes_.data());
        room_ = bytes_.size() / sizeof(T);
    }

    static constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max() / 4 / sizeof(T);

    SpilledBytes bytes_;
    T* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t room_ = 0;
};

} // namespace frostfill
