// SPDX-License-Identifier: MIT
// Columns of spheres that a snapshot carries, in streams of their own.
#include "run_file/frame_codec.hpp"

#include <algorithm>
#include <iterator>

namespace frostfill
{

std::string streamOf(const Column& column)
{
    return column.name + (column.isWhole() ? ":uint32" : ":float32");
}

void FrameCodec::carry(const Column& column)
{
    if (snapshot_.values(column) == nullptr)
    {
        snapshot_.columns.emplace_back(column).bits.resize(snapshot_.states.size());
    }
}

/// Of the spheres that are said to have changed, and of new ones.
std::vector<std::uint32_t> FrameCodec::changedIn(const ColumnValues& known,
                                                 const Given& given) const
{
    const std::vector<std::uint32_t>& changed = given.snapshot.changed;
    const ColumnValues* now = given.snapshot.values(known.column());
    std::vector<std::uint32_t> ids;
    std::set_union(changed.begin(), changed.end(), renewed_.begin(), renewed_.end(),
                   std::back_inserter(ids));
    std::erase_if(
        ids, [&](std::uint32_t id)
        { return now == nullptr || id >= now->bits.size() || now->bits[id] == known.bits[id]; });
    return ids;
}

// Of each column the spheres whose values have changed, and then the values.
template <typename Bytes>
void FrameCodec::goThroughCarried(Named<Bytes>& streams, const Given* given)
{
    revalued_.clear();
    for (ColumnValues& known : snapshot_.columns)
    {
        const Column& column = known.column();
        Bytes& stream = streams[streamOf(column)];
        std::vector<std::uint32_t> ids =
            given != nullptr ? changedIn(known, *given) : std::vector<std::uint32_t>();
        stream.pass(ids, snapshot_.states.size());
        for (const std::uint32_t id : ids)
        {
            std::uint32_t bits = given != nullptr ? given->snapshot.values(column)->bits[id] : 0;
            if (column.isWhole())
            {
                std::int64_t value = bits;
                stream.pass(value, std::int64_t{known.bits[id]});
                bits = static_cast<std::uint32_t>(value);
            }
            else
            {
                stream.passRaw(bits);
            }
            known.bits[id] = bits;
        }
        revalued_.insert(revalued_.end(), ids.begin(), ids.end());
    }
}

template void FrameCodec::goThroughCarried(Streams& streams, const Given* given);
template void FrameCodec::goThroughCarried(StreamReaders& streams, const Given* given);

} // namespace frostfill
