// SPDX-License-Identifier: MIT
// In the place of the engines that are not built in.
#include "study/peers/peer.hpp"

#include <frostfill/error.hpp>

#include <string>

namespace frostfill
{
namespace
{

/// Where all are built in, nothing does.
[[noreturn, maybe_unused]] void throwNotBuiltIn(const std::string& engine,
                                                const std::string& package)
{
    throw Error(ErrorCode::missingProgram, engine + " is not built in: apt-get install " + package +
                                               " and configure with -DFROSTFILL_PEERS=ON");
}

} // namespace

#ifndef FROSTFILL_WITH_BULLET
bool hasBullet()
{
    return false;
}

PeerResult runBullet(const PeerTask& /*task*/, double /*step*/)
{
    throwNotBuiltIn("Bullet", "libbullet-dev");
}
#endif

#ifndef FROSTFILL_WITH_ODE
bool hasOde()
{
    return false;
}

PeerResult runOde(const PeerTask& /*task*/, double /*step*/)
{
    throwNotBuiltIn("ODE", "libode-dev");
}
#endif

} // namespace frostfill
