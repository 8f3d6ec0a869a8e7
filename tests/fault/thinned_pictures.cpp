// SPDX-License-Identifier: MIT
// Writes fifty small pictures into the folder of its argument, of which at most six are kept: what
// a run does that has far more than it planned.
#include <frostfill/output.hpp>

#include <string>

int main(int count, char** arguments)
{
    if (count != 2)
    {
        return 64;
    }
    frostfill::PngSequence sequence(arguments[1], 6, {{"Software", "Frostfill"}});
    frostfill::Image image;
    image.width = 8;
    image.height = 6;
    for (int i = 0; i < 50; ++i)
    {
        image.pixels.assign(std::size_t{8} * 6 * 3, static_cast<std::uint8_t>(i));
        sequence.put(static_cast<std::size_t>(i), image, {}, {{"Frame", std::to_string(i)}});
    }
    return 0;
}
