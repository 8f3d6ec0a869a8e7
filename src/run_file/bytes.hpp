// SPDX-License-Identifier: MIT
// Room: the run file, run.frost: what any picture of a run needs, appended as the run goes. Its
// bytes are described in docs/run-file.md.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

static_assert(std::endian::native == std::endian::little,
              "numbers are written as they lie in memory");

/// Bytes that end too early or say what cannot be.
class DamagedBytes : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// a + b and a - b of numbers that a file gives: they wrap round where they are too large.
[[nodiscard]] constexpr std::int64_t wrappedSum(std::int64_t a, std::int64_t b)
{
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
[[nodiscard]] constexpr std::int64_t wrappedDifference(std::int64_t a, std::int64_t b)
{
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

/// Appends numbers to a string. Counts and differences take as few bytes as they need (LEB128;
/// signs are folded in as in Protocol Buffers).
class ByteWriter
{
public:
    template <typename Value>
    void raw(const Value& value)
    {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void count(std::uint64_t value)
    {
        for (; value >= 0x80; value >>= 7)
        {
            bytes_ += static_cast<char>(value | 0x80);
        }
        bytes_ += static_cast<char>(value);
    }
    void difference(std::int64_t value)
    {
        count((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
    }
    // ByteReader reads this in the same words, as it does raw().
    void passSize(std::uint64_t& size, std::uint64_t /*known*/) { count(size); }
    void pass(std::uint64_t& number, std::uint64_t /*largest*/) { count(number); }
    void pass(std::int64_t& number, std::int64_t before)
    {
        difference(wrappedDifference(number, before));
    }
    /// Ascending ids: how many, then each as the difference from the one before.
    void pass(const std::vector<std::uint32_t>& ids, std::size_t /*below*/)
    {
        count(ids.size());
        std::uint32_t before = 0;
        for (const std::uint32_t id : ids)
        {
            count(id - before);
            before = id;
        }
    }
    [[nodiscard]] std::string& bytes() { return bytes_; }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Reads what ByteWriter wrote. Throws DamagedBytes at the end.
class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes = {}) : rest_(bytes) {}

    template <typename Value>
    void raw(Value& value)
    {
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
    }
    [[nodiscard]] std::uint64_t count()
    {
        std::uint8_t first = 0;
        raw(first); // nearly always the only one
        if (first < 0x80)
        {
            return first;
        }
        std::uint64_t value = first & 0x7F;
        for (int shift = 7; shift < 64; shift += 7)
        {
            std::uint8_t byte = 0;
            raw(byte);
            value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
            if (byte < 0x80)
            {
                return value;
            }
        }
        throw DamagedBytes("has a number that does not end");
    }
    /// A count of things that take at least a byte each.
    [[nodiscard]] std::size_t countOfMany()
    {
        const std::uint64_t value = count();
        if (value > rest_.size())
        {
            throw DamagedBytes("counts more than there is");
        }
        return static_cast<std::size_t>(value);
    }
    [[nodiscard]] std::int64_t difference()
    {
        const std::uint64_t folded = count();
        return static_cast<std::int64_t>(folded >> 1) ^ -static_cast<std::int64_t>(folded & 1);
    }
    // What ByteWriter writes in the same words.
    /// Of a list that grows from `known`, by at most as many as there are bytes.
    void passSize(std::uint64_t& size, std::uint64_t known) { pass(size, known + rest_.size()); }
    void pass(std::uint64_t& number, std::uint64_t largest)
    {
        number = count();
        if (number > largest)
        {
            throw DamagedBytes("has a number that is too large");
        }
    }
    void pass(std::int64_t& number, std::int64_t before)
    {
        number = wrappedSum(before, difference());
    }
    /// Ascending ids, all of them below.
    void pass(std::vector<std::uint32_t>& ids, std::size_t below)
    {
        ids.resize(countOfMany());
        std::uint64_t id = 0;
        for (std::uint32_t& each : ids)
        {
            id += count();
            if (id >= below)
            {
                throw DamagedBytes("names a sphere or polygon that is not there");
            }
            each = static_cast<std::uint32_t>(id);
        }
    }
    [[nodiscard]] std::string_view take(std::size_t bytes)
    {
        if (bytes > rest_.size())
        {
            throw DamagedBytes("ends too early");
        }
        const std::string_view taken(rest_.data(), bytes);
        rest_.remove_prefix(bytes);
        return taken;
    }
    [[nodiscard]] bool done() const { return rest_.empty(); }

private:
    std::string_view rest_;
};

/// Bytes by the name of what they hold. Numbers of one kind pack better among themselves.
template <typename Bytes>
using Named = std::map<std::string, Bytes, std::less<>>;
using Streams = Named<ByteWriter>;
using StreamReaders = Named<ByteReader>;

/// All streams in a row: their names and lengths first.
[[nodiscard]] std::string joined(Streams&& streams);
/// The streams that were joined, as long as the bytes are there. Throws DamagedBytes.
[[nodiscard]] StreamReaders split(std::string_view bytes);

} // namespace frostfill
