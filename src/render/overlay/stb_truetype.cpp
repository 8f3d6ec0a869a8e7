// SPDX-License-Identifier: MIT
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>
