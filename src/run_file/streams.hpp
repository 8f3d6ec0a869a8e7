// SPDX-License-Identifier: MIT
#pragma once

#include "run_file/bytes.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace frostfill
{

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
