// SPDX-License-Identifier: MIT
#include "lab/program_peer.hpp"

#include "lab/program_talk.hpp"
#include "lab/rigid_body_run.hpp"
#include "simulation/contact/contact.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>

namespace frostfill
{
namespace
{

/// Wall-clock time that a program may take, over its limit of processor time: one that waits for
/// something else than its processor for so long hangs. Less, and a busy machine ends what works.
constexpr double kPatience = 10;
constexpr double kTrialSeconds = 6;     ///< of processor time; starting an engine counts
constexpr std::size_t kMostQuoted = 60; // of what a program says [byte]

/// For a message: control characters and line ends are spaces, one for several.
std::string oneLine(std::string_view text)
{
    std::string line;
    for (const char byte : text)
    {
        const bool isSpace = static_cast<unsigned char>(byte) <= ' ' || byte == 127;
        if (!isSpace || (!line.empty() && line.back() != ' '))
        {
            line += isSpace ? ' ' : byte;
        }
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

std::string quoted(const std::string& said)
{
    const bool isLong = said.size() > kMostQuoted;
    return fmt::format("'{}{}'", oneLine(said.substr(0, kMostQuoted)), isLong ? "..." : "");
}

/// Three numbers and nothing else.
std::optional<Eigen::Vector3d> readPlace(std::string_view line)
{
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis)
    {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        const auto [end, error] =
            std::from_chars(line.data(), line.data() + line.size(), place[axis]);
        if (error != std::errc() || !std::isfinite(place[axis]))
        {
            return std::nullopt;
        }
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
        if (axis < 2 && line.find_first_of(" \t") != 0)
        {
            return std::nullopt;
        }
    }
    return line.find_first_not_of(" \t\r") == std::string_view::npos ? std::optional(place)
                                                                     : std::nullopt;
}

/// What a program is told before it starts.
std::string introduction(const PeerTask& task, double step)
{
    std::string text = fmt::format(
        "frostfill-peer 1\nrestitution {:.17g}\nfriction {:.17g}\nstep {:.17g}\nbounce {:.17g}\n"
        "still {:.17g}\nspheres {}\nvertices {}\n",
        task.restitution, task.friction, step, Restitution().bounceSpeed, kPeerStill / kPeerWindow,
        task.count, task.mesh.vertices.size());
    auto out = std::back_inserter(text);
    for (const Eigen::Vector3d& v : task.mesh.vertices)
    {
        fmt::format_to(out, "{:.17g} {:.17g} {:.17g}\n", v.x(), v.y(), v.z());
    }
    fmt::format_to(out, "triangles {}\n", task.mesh.triangles.size());
    for (const auto& t : task.mesh.triangles)
    {
        fmt::format_to(out, "{} {} {}\n", t[0], t[1], t[2]);
    }
    return text;
}

/// The spheres in the world of another program. All but `places` goes out without an answer.
class ProgramBodies
{
public:
    ProgramBodies(const PeerTask& task, const ProgramPeer& peer, double step)
        : name_(peer.name), talk_(peer.program, kPatience * task.secondsLimit),
          secondsLimit_(task.secondsLimit)
    {
        if (talk_.error() != 0)
        {
            throw Error(ErrorCode::missingProgram,
                        fmt::format("the engine {} cannot be started: '{}': {}", name_,
                                    peer.program, std::strerror(talk_.error())));
        }
        talk_.say(introduction(task, step) + "start\n");
        expect("ready");
    }

    void addSphere(const Eigen::Vector3d& place)
    {
        talk_.say(fmt::format("add {:.17g} {:.17g} {:.17g}\n", place.x(), place.y(), place.z()));
        ++size_;
    }
    /// Close to the limit of time each step is waited for, so that the program does not pass it by
    /// all those that it has been told.
    void step()
    {
        talk_.say("step\n");
        ++stepsTold_;
        if (secondsThen_ + stepsTold_ * secondsOfStep_ > secondsLimit_)
        {
            static_cast<void>(places());
        }
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::vector<Eigen::Vector3d> places()
    {
        talk_.say("places\n");
        expect(fmt::format("places {}", size_));
        std::vector<Eigen::Vector3d> places;
        while (places.size() < size_)
        {
            const std::string expected = fmt::format("three numbers for sphere {}", places.size());
            const std::string said = hear(expected);
            const auto place = readPlace(said);
            if (!place)
            {
                refuse(expected, "said " + quoted(said));
            }
            places.push_back(*place);
        }
        const double now = seconds();
        secondsOfStep_ = stepsTold_ > 0 ? (now - secondsThen_) / stepsTold_ : secondsOfStep_;
        secondsThen_ = now;
        stepsTold_ = 0;
        return places;
    }
    [[nodiscard]] double seconds() const { return talk_.seconds(); }
    void end()
    {
        talk_.say("end\n");
        talk_.end();
    }

private:
    std::string hear(const std::string& expected)
    {
        std::optional<std::string> line = talk_.hear();
        if (!line)
        {
            refuse(expected, talk_.ending());
        }
        return *std::move(line);
    }
    void expect(const std::string& answer)
    {
        const std::string said = hear("'" + answer + "'");
        if (oneLine(said) != answer)
        {
            refuse("'" + answer + "'", "said " + quoted(said));
        }
    }
    [[noreturn]] void refuse(const std::string& expected, const std::string& what)
    {
        static_cast<void>(talk_.ending()); // what it has to complain is there then
        const std::string errors = oneLine(talk_.errors());
        throw Error(ErrorCode::missingProgram,
                    fmt::format("the engine {} was to answer {}, but {}{}", name_, expected, what,
                                errors.empty() ? "" : "; its errors end with: " + errors));
    }

    std::string name_;
    ProgramTalk talk_;
    std::size_t size_ = 0;
    double secondsLimit_;
    double secondsThen_ = 0;   ///< when it told its places last
    double secondsOfStep_ = 0; ///< of each until then
    int stepsTold_ = 0;        ///< since then
};

ProgramPeer readProgramPeer(const std::string& text)
{
    const std::size_t sign = text.find('=');
    ProgramPeer peer;
    if (sign != std::string::npos)
    {
        peer = {text.substr(0, sign), text.substr(sign + 1)};
    }
    if (peer.name.empty() || peer.program.empty())
    {
        throw Error(ErrorCode::usage,
                    fmt::format("'{}' must be NAME=PROGRAM, such as Jolt=./jolt.mjs", text));
    }
    const auto isOdd = [](char byte)
    { return static_cast<unsigned char>(byte) < ' ' || std::strchr(",\"'\\{}", byte) != nullptr; };
    if (std::any_of(peer.name.begin(), peer.name.end(), isOdd))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("'{}' cannot name an engine in tables and figures: it has a comma, "
                                "a quotation mark, a brace or a backslash",
                                oneLine(peer.name)));
    }
    return peer;
}

} // namespace

std::vector<ProgramPeer> readProgramPeers(const std::vector<std::string>& texts)
{
    std::set<std::string> names = {kOurName};
    std::vector<ProgramPeer> peers;
    for (const std::string& text : texts)
    {
        peers.push_back(readProgramPeer(text));
        if (!names.insert(peers.back().name).second)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("two engines have the name {}: give '{}' another one",
                                    peers.back().name, peers.back().program));
        }
    }
    return peers;
}

PeerResult runProgramPeer(const ProgramPeer& peer, const PeerTask& task, double step)
{
    return runRigidBodies(task, step, ProgramBodies(task, peer, step));
}

void tryProgramPeer(const ProgramPeer& peer)
{
    PeerTask task;
    task.mesh = cubeFilledTo(0.1, 10);
    task.count = 1;
    task.timeLimit = 0.01;
    task.secondsLimit = kTrialSeconds;
    static_cast<void>(runProgramPeer(peer, task, task.timeLimit));
}

} // namespace frostfill
