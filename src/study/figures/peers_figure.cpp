// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/peers/peer_study.hpp"

namespace frostfill
{
namespace
{

void makePeersData(const FigureFolder& folder)
{
    if (folder.reuse("peers.csv"))
    {
        return;
    }
    requirePeers();
    const auto progress = [&](std::size_t done, std::size_t all, const std::string& what)
    { folder.progress(done, all, what); };
    folder.write("peers.csv", peersCsv(measurePeers(folder.quick(), {}, progress)));
}

} // namespace

Figure peersFigure()
{
    return {"peers",       "other engines on the same cube",
            true,          200,
            makePeersData, embedded::figure_peers};
}

} // namespace frostfill
