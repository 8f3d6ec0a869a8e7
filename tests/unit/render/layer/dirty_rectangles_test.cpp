// SPDX-License-Identifier: MIT
#include "render/layer/scene_painter.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using testing_support::Numbers;

TEST(DirtyRectangles, CoverAllThatWasAddedOnceAndStayInThePicture)
{
    Numbers numbers;
    for (const int count : {0, 1, 2, 20, 100, 1000})
    {
        DirtyRectangles dirty(320, 200);
        std::vector<PixelRectangle> added;
        for (int i = 0; i < count; ++i)
        {
            const int x = static_cast<int>(400 * numbers.next()) - 40;
            const int y = static_cast<int>(300 * numbers.next()) - 50;
            const int size = 1 + static_cast<int>(20 * numbers.next());
            added.push_back({x, y, x + size, y + size});
        }
        dirty.add(added);
        const auto& joined = dirty.joined();
        for (int y = 0; y < 200; ++y)
        {
            for (int x = 0; x < 320; ++x)
            {
                const PixelRectangle pixel = {x, y, x + 1, y + 1};
                const auto meets = [&](const PixelRectangle& r) { return r.overlaps(pixel); };
                const auto times = std::count_if(joined.begin(), joined.end(), meets);
                ASSERT_LE(times, 1);
                if (std::any_of(added.begin(), added.end(), meets))
                {
                    ASSERT_EQ(times, 1) << x << "," << y << " of " << count;
                }
            }
        }
        for (const PixelRectangle& rectangle : joined)
        {
            EXPECT_EQ(common(rectangle, {0, 0, 320, 200}), rectangle);
        }
    }
}

TEST(DirtyRectangles, FarAwayOnesStayApart)
{
    DirtyRectangles dirty(1000, 1000);
    dirty.add({0, 0, 10, 10});
    dirty.add({900, 900, 910, 910});
    dirty.add({5, 5, 15, 15});
    EXPECT_EQ(dirty.joined().size(), 2U);
}

} // namespace
} // namespace frostfill
