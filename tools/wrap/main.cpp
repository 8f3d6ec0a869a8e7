// SPDX-License-Identifier: GPL-3.0-or-later
// frostfill-wrap skin IN OUT ALPHA OFFSET BYTES SECONDS
// frostfill-wrap unite IN OUT BYTES SECONDS
// Called by frostfill, which writes IN and reads OUT, PLY files in memory. BYTES of address space
// and SECONDS of processor time are this process's limits. Exit code 65 with a reason on standard
// output: the mesh cannot be worked on.
#include "base/resources.hpp"
#include "work.hpp"

#include <frostfill/error.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <vector>

namespace
{

using namespace frostfill;

void limit(int what, const std::string& value)
{
    rlimit now = {};
    getrlimit(static_cast<__rlimit_resource>(what), &now);
    now.rlim_cur = std::min<rlim_t>(now.rlim_max, std::strtoull(value.c_str(), nullptr, 10));
    setrlimit(static_cast<__rlimit_resource>(what), &now);
}

void limitThisProcess(const std::string& bytes, const std::string& seconds)
{
    limit(RLIMIT_CORE, "0");
    limit(RLIMIT_CPU, seconds);
#ifndef FROSTFILL_SANITIZED
    limit(RLIMIT_AS, bytes);
#else
    (void)bytes;
#endif
}

/// Into a file that is there, because the one who calls waits with it open.
void write(const TriangleMesh& mesh, const std::string& file)
{
    std::ofstream output(file, std::ios::binary);
    output << plyBytes(mesh) << std::flush;
    if (!output)
    {
        throw std::bad_alloc(); // the file is in memory
    }
}

int run(const std::vector<std::string>& given)
{
    if (given.size() == 7 && given[0] == "skin")
    {
        limitThisProcess(given[5], given[6]);
        const double alpha = std::strtod(given[3].c_str(), nullptr);
        const double offset = std::strtod(given[4].c_str(), nullptr);
        write(wrap::skinOf(readMesh(given[1]), alpha, offset), given[2]);
        return 0;
    }
    if (given.size() == 5 && given[0] == "unite")
    {
        limitThisProcess(given[3], given[4]);
        write(wrap::unionOf(readMesh(given[1])), given[2]);
        return 0;
    }
    std::fputs("frostfill-wrap makes skins and unions for frostfill, which calls it:\n"
               "  frostfill fill MESH --wrap auto\n"
               "  frostfill fill MESH --set object.unite=true\n"
               "It is free software under the GNU GPL, version 3 or later, and uses CGAL.\n",
               stdout);
    return static_cast<int>(ErrorCode::usage);
}

} // namespace

int main(int argumentCount, char** arguments)
{
    try
    {
        return run({arguments + 1, arguments + argumentCount});
    }
    catch (const wrap::Refused& why)
    {
        std::puts(why.what());
        return static_cast<int>(ErrorCode::badData);
    }
    catch (const std::bad_alloc&)
    {
        return static_cast<int>(ErrorCode::outOfMemory);
    }
    catch (const std::exception& error)
    {
        std::puts(error.what());
        return static_cast<int>(ErrorCode::postcondition);
    }
}
