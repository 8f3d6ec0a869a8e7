// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace frostfill
{

/// Asked within steps that take long: whether to end the step early.
struct StopRequest
{
    std::function<bool()> asked; ///< may be empty

    [[nodiscard]] bool isAsked() const { return asked && asked(); }
};

} // namespace frostfill
