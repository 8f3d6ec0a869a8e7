# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2154 # root is set by who sources this
# Sourced by the other scripts, with $root set: installs what is missing and builds.

say()
{
    printf '%s\n' "$*" >&2
}

# missing_packages LIST...: the packages of those lists of scripts/packages that are not installed.
missing_packages()
{
    awk -v lists=" $* " '/^#/ { next } /^\[/ { list = substr($1, 2, length($1) - 2); next }
        index(lists, " " list " ")' "$root/scripts/packages" | while read -r package; do
        status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || status=
        [ "$status" = installed ] || printf '%s ' "$package"
    done
}

# install_missing_packages LIST...
install_missing_packages()
{
    if ! command -v dpkg-query >/dev/null 2>&1; then
        say "This is no Debian system: install the equivalents of the packages in scripts/packages."
        return 0
    fi
    missing=$(missing_packages "$@")
    [ -n "$missing" ] || return 0

    say "Missing Debian packages: $missing"
    if [ "$(id -u)" -eq 0 ]; then
        as_root='env'
    elif command -v sudo >/dev/null 2>&1; then
        say "Installing them needs sudo, which may ask for your password."
        as_root="sudo env"
    else
        say "Run this as root, then try again: apt-get install --no-install-recommends $missing"
        exit 69
    fi
    # shellcheck disable=SC2086 # lists of words on purpose
    if ! { $as_root apt-get update -q >&2 &&
        $as_root DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
            $missing >&2; }; then
        say "The packages could not be installed; see above."
        exit 69
    fi
}

# As many compilers as there are cores, but none without a gigabyte and a half of memory: the
# heaviest source needs about one.
build_jobs()
{
    cores=$(nproc 2>/dev/null || echo 1)
    by_memory=$(awk '/^MemAvailable:/ { print int($2 / 1572864) }' /proc/meminfo 2>/dev/null)
    [ -n "$by_memory" ] || by_memory=1
    [ "$by_memory" -ge 1 ] || by_memory=1
    if [ "$by_memory" -lt "$cores" ]; then echo "$by_memory"; else echo "$cores"; fi
}

# has_targets TARGET...: whether the release preset has been configured so that it has them.
has_targets()
{
    for target; do
        grep -qs "^build $target: phony" "$root/build/release/build.ninja" || return 1
    done
}

# configure_release OPTION...: configures the release preset, without tests, which need packages of
# their own, unless they are there or asked for.
configure_release()
{
    has_targets test_support || set -- -DFROSTFILL_TESTS=OFF "$@"
    say "Configuring ..."
    (cd "$root" && cmake --preset release "$@" >&2) || {
        say "Configuring failed; see above."
        exit 70
    }
}

# build_release TARGET...: builds targets of the release preset, which is configured.
build_release()
{
    say "Building ..."
    (cd "$root" && cmake --build --preset release --parallel "$(build_jobs)" --target "$@" >&2) || {
        say "Building failed; see above."
        exit 70
    }
}
