// SPDX-License-Identifier: MIT
#pragma once

namespace frostfill
{

/// The deflate hook of stb_image_write: a zlib stream of `bytes`, to be freed with free(), or null.
/// The hook's quality is not used: the level is ours.
unsigned char* deflateForStb(unsigned char* bytes, int count, int* countOut, int quality);

/// The checksum hook of stb_image_write.
unsigned int crc32ForStb(unsigned char* bytes, int count);

} // namespace frostfill
