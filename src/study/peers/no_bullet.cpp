// SPDX-License-Identifier: MIT
// In the place of Bullet when it is not built in.
#include "study/peers/peer.hpp"

#include <frostfill/error.hpp>

namespace frostfill
{

bool hasBullet()
{
    return false;
}

PeerResult runBullet(const PeerTask& /*task*/, double /*step*/)
{
    throw Error(ErrorCode::missingProgram, "Bullet is not built in: configure with "
                                           "-DFROSTFILL_PEERS=ON");
}

} // namespace frostfill
