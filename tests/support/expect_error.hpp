// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/error.hpp>

#include <gtest/gtest.h>

#include <string>

namespace frostfill::test
{

/// Expects `action` to throw an Error with this code whose message holds every one of `parts`.
template <typename Action, typename... Parts>
void expectError(ErrorCode code, Action action, const Parts&... parts)
{
    try
    {
        action();
        ADD_FAILURE() << "nothing was thrown";
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), code) << error.what();
        const std::string message = error.what();
        for (const std::string& part : {std::string(parts)...})
        {
            EXPECT_NE(message.find(part), std::string::npos)
                << "'" << part << "' is not in: " << message;
        }
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

} // namespace frostfill::test
