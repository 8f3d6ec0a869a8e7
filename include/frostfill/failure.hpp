// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/error.hpp>

#include <string>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What an exception comes to: an exit code and a sentence.
struct Failure
{
    ErrorCode code = ErrorCode::postcondition;
    std::string message;
};

/// That of the exception that is being handled. To be called in a catch block only.
[[nodiscard]] Failure currentFailure();

} // namespace frostfill
#pragma GCC visibility pop
