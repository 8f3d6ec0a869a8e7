// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// The deflate hook of stb_image_write. Returns a zlib stream of `bytes`, which the caller frees
/// with free(), or null. Ignores `quality`: the compression level is fixed.
unsigned char* deflateForStb(unsigned char* bytes, int count, int* countOut, int quality);

/// The checksum hook of stb_image_write.
unsigned int crc32ForStb(unsigned char* bytes, int count);

} // namespace frostfill
