// SPDX-License-Identifier: MIT
#include "run_file/bytes.hpp"

#include <utility>
#include <vector>

namespace frostfill
{

std::string joined(Streams&& streams)
{
    ByteWriter all;
    std::size_t size = 0;
    all.count(streams.size());
    for (const auto& [name, stream] : streams)
    {
        all.count(name.size());
        all.bytes() += name;
        all.count(stream.bytes().size());
        size += stream.bytes().size();
    }
    all.bytes().reserve(all.bytes().size() + size);
    for (auto& [name, stream] : streams)
    {
        all.bytes() += stream.bytes();
        stream.bytes() = {}; // memory of large runs is at its largest here
    }
    return std::move(all.bytes());
}

StreamReaders split(std::string_view bytes)
{
    ByteReader in(bytes);
    std::vector<std::pair<std::string, std::size_t>> sizes(in.countOfMany());
    for (auto& [name, size] : sizes)
    {
        name = in.take(in.countOfMany());
        size = in.countOfMany();
    }
    StreamReaders streams;
    for (const auto& [name, size] : sizes)
    {
        streams[name] = ByteReader(in.take(size));
    }
    return streams;
}

} // namespace frostfill
