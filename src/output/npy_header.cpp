// SPDX-License-Identifier: MIT
#include "output/npy_header.hpp"

#include <fmt/format.h>

namespace frostfill
{

// A Python dictionary, filled up so that values begin at a multiple of 64 bytes.
std::string npyHeader(std::string_view type, const std::vector<std::size_t>& shape)
{
    std::string dictionary = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}",
                                         type, fmt::join(shape, ", "));
    dictionary += shape.size() == 1 ? ",), }" : "), }";
    constexpr std::size_t kBefore = 10;
    dictionary.append(63 - (kBefore + dictionary.size()) % 64, ' ');
    dictionary += '\n';
    std::string header("\x93NUMPY\x01\x00", 8);
    header += static_cast<char>(dictionary.size() & 0xFF); // the low byte first
    header += static_cast<char>(dictionary.size() >> 8);
    return header + dictionary;
}

} // namespace frostfill
