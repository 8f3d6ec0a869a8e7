// SPDX-License-Identifier: MIT
#include "image/deflate.hpp"

#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS frostfill::deflateForStb
#define STBIW_CRC32 frostfill::crc32ForStb
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
