# shellcheck shell=bash
# Shared by the scripts of this folder: messages, what has to be installed, configuring and building.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
deps=$root/.deps

# Exit codes, as those of the program.
# shellcheck disable=SC2034  # used by the scripts that read this file
readonly refused=2 machine_lacks=4

say() { printf 'pliant: %s\n' "$*" >&2; }
fail() {
    local code=$1
    shift
    say "$*"
    exit "$code"
}

# logged WHAT COMMAND...: runs COMMAND, whose output is shown only if it fails or if somebody is watching. Of a failure the
# last $lines lines are shown, 2000 unless set.
logged() {
    local what=$1 log start=$SECONDS
    shift
    if [[ -t 2 ]]; then
        "$@" >&2 || return
    else
        log=$(mktemp "${TMPDIR:-/tmp}/pliant.XXXXXX")
        if ! "$@" >"$log" 2>&1 </dev/null; then
            tail -n "${lines:-2000}" "$log" >&2
            rm -f "$log"
            return 1
        fi
        rm -f "$log"
    fi
    if ((SECONDS - start > 1)); then say "$what took $((SECONDS - start)) s"; fi
}

# ---- Packages of the distribution, as "why: package package ..." ----
run_packages=(
    "compiler and build tools: g++ cmake ninja-build xz-utils"
    "numbers, threads, text and the command line: libeigen3-dev libtbb-dev libfmt-dev nlohmann-json3-dev libcli11-dev zlib1g-dev libpugixml-dev"
    "windows and pictures: libglfw3-dev libosmesa6-dev libegl-dev libgl-dev libgl1 libegl1 libegl-mesa0 libgl1-mesa-dri"
    "picture and PDF files, GL functions and letters: libpng-dev libgif-dev libhpdf-dev python3-glad fonts-dejavu-core fonts-dejavu-extra"
)
test_packages=(
    "a screen, a mouse and a second locale for the tests: xvfb xdotool x11-xkb-utils locales"
    "another program that reads the files of VTK: python3-meshio"
)
bench_packages=("the benchmarks: libbenchmark-dev")
fuzz_packages=("the fuzzers: clang libclang-rt-dev")
format_packages=("formatting: clang-format")

# need_packages GROUP...: says what is missing and why, and installs it. When all is there the network is left alone.
need_packages() {
    local group package installed missing all_missing=()
    command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || return 0
    # shellcheck disable=SC2016,SC2048,SC2086  # dpkg-query expands its own fields; the groups are lists of words
    installed=" $(dpkg-query --show --showformat='${db:Status-Status}:${Package} ' ${*#*: } 2>/dev/null || true)"
    for group in "$@"; do
        missing=()
        for package in ${group#*: }; do
            [[ $installed == *" installed:$package "* ]] || missing+=("$package")
        done
        if ((${#missing[@]})); then
            say "needs, for ${group%%: *}: ${missing[*]}"
            all_missing+=("${missing[@]}")
        fi
    done
    if ((${#all_missing[@]})); then install_packages "${all_missing[@]}"; fi
}

install_packages() {
    local as_root=(env DEBIAN_FRONTEND=noninteractive) apt=(apt-get -q -o DPkg::Lock::Timeout=300)
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null || ! { sudo --non-interactive true 2>/dev/null || [[ -t 0 ]]; }; then
            say "installing them needs root. Type this as root, then start this script again:"
            fail "$machine_lacks" "apt-get update && apt-get install --no-install-recommends $*"
        fi
        as_root=(sudo "${as_root[@]}")
    fi
    local lines=10
    # One source of several that does not answer need not matter; what does matter fails in the next line.
    logged "reading the package lists" "${as_root[@]}" "${apt[@]}" update || true
    if ! logged "installing" "${as_root[@]}" "${apt[@]}" install --yes --no-install-recommends "$@"; then
        fail "$machine_lacks" "could not be installed. By hand: apt-get update && apt-get install --no-install-recommends $*"
    fi
    packages_changed=yes
}
packages_changed=no

# ---- The pinned packages, kept in .deps. They come from the Debian archive that this machine's apt uses already,
# ---- through an apt configuration of its own, so that neither root nor a change to the system is needed.
imgui_version=1.90.1+ds-1
catch2_version=3.7.1
onetbb_version=2021.8.0
debian_keyring=/usr/share/keyrings/debian-archive-keyring.gpg

# of_system NAME: a variable of /etc/os-release.
of_system() {
    # shellcheck source=/dev/null
    (. /etc/os-release && printf %s "${!1:-}")
}

# The address of the main archive as apt itself reads it from its sources, in whatever format they are.
archive_address() {
    local suites
    suites="$(of_system VERSION_CODENAME)|stable|oldstable|testing|unstable|sid"
    apt-get update --print-uris | sed -n -E "s#^'([^']+)/dists/($suites)/InRelease'.*#\1#p" | head -n 1
}

# private_apt FOLDER SUITE TYPE: an apt configuration with its lists and caches in FOLDER that knows SUITE alone.
private_apt() {
    local folder=$1 suite=$2 type=$3 address
    address=$(archive_address)
    if [[ -z $address ]]; then
        say "apt knows no Debian archive: its sources name no suite $(of_system VERSION_CODENAME)"
        return 1
    fi
    mkdir -p "$folder/state/lists/partial" "$folder/cache/archives/partial" || return
    printf '%s [signed-by=%s] %s %s main\n' "$type" "$debian_keyring" "$address" "$suite" >"$folder/sources.list"
    cat >"$folder/apt.conf" <<CONF
Dir::Etc::SourceList "$folder/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::Etc::Preferences "/dev/null";
Dir::Etc::PreferencesParts "/dev/null";
Dir::State "$folder/state";
Dir::State::status "/var/lib/dpkg/status";
Dir::Cache "$folder/cache";
Acquire::Languages "none";
APT::Sandbox::User "root";
APT::Update::Error-Mode "any";
CONF
    APT_CONFIG=$folder/apt.conf apt-get -q update
}

# get_pinned NAME VERSION SUITE TYPE: puts the package into .deps/NAME unless it is there. An interrupted run leaves nothing
# that a later one would take for complete.
get_pinned() {
    local name=$1 version=$2 suite=$3 type=$4 work lines=10
    [[ -f $deps/$name/.version && $(<"$deps/$name/.version") == "$version" ]] && return 0
    if [[ ! -r $debian_keyring ]] || ! command -v apt-get >/dev/null; then
        say "not a Debian system: CMake downloads $name by its pinned tag"
        return 0
    fi
    say "getting $name $version from the Debian archive ($suite)"
    mkdir -p "$deps"
    work=$(mktemp -d "$deps/.$name.XXXXXX")
    if ! logged "getting $name" private_apt "$work" "$suite" "$type" || ! (cd "$work" && logged "unpacking $name" "unpack_$name"); then
        rm -rf "$work"
        fail "$machine_lacks" "could not get $name $version. It needs the network once; afterwards it is kept in .deps"
    fi
    printf '%s\n' "$version" >"$work/tree/.version"
    rm -rf "${deps:?}/$name"
    mv "$work/tree" "$deps/$name"
    rm -rf "$work"
}

# In the folder of a private apt configuration: fetches the package and leaves its files in `tree`.
unpack_imgui() {
    export APT_CONFIG=$PWD/apt.conf
    apt-get -q source --download-only --tar-only "imgui=$imgui_version" && mkdir tree &&
        tar -xf imgui_*.orig.tar.* -C tree --strip-components=1
}

# What the distribution calls the version proper, with its own revision behind it.
revision_of() {
    local package=$1 version=$2
    apt-cache madison "$package" | awk -v pin="$version-" 'index($3, pin) == 1 {print $3; exit}'
}

unpack_catch2() {
    export APT_CONFIG=$PWD/apt.conf
    local revision
    revision=$(revision_of libcatch2-dev "$catch2_version") &&
        apt-get -q download "libcatch2-dev=$revision" && dpkg-deb -x libcatch2-dev_*.deb tree
}

unpack_onetbb() {
    export APT_CONFIG=$PWD/apt.conf
    local revision
    revision=$(revision_of onetbb "$onetbb_version") &&
        apt-get -q source --download-only --tar-only "onetbb=$revision" && mkdir tree &&
        tar -xf onetbb_*.orig.tar.* -C tree --strip-components=1
}

prepare_run() {
    need_packages "${run_packages[@]}"
    get_pinned imgui "$imgui_version" trixie deb-src
}

prepare_test() {
    local suite=trixie
    # A library compiled by Debian 13's compiler does not link on Debian 12.
    if [[ $(of_system VERSION_CODENAME) == bookworm ]]; then suite=bookworm-backports; fi
    need_packages "${run_packages[@]}" "${test_packages[@]}"
    get_pinned imgui "$imgui_version" trixie deb-src
    get_pinned catch2 "$catch2_version" "$suite" deb
}

# The thread sanitizer has to see into oneTBB, so that is built from source for it.
prepare_tsan() {
    prepare_test
    get_pinned onetbb "$onetbb_version" bookworm deb-src
}

prepare_bench() {
    need_packages "${run_packages[@]}" "${bench_packages[@]}"
    get_pinned imgui "$imgui_version" trixie deb-src
}

prepare_fuzz() { need_packages "${run_packages[@]}" "${fuzz_packages[@]}"; }

prepare_format() { need_packages "${format_packages[@]}"; }

# ---- Configuring and building ----

# configure PRESET [NAME=VALUE...]: only if the build folder is new or one of the settings or packages has changed.
configure() {
    local preset=$1 setting cache=$root/build/$1/CMakeCache.txt settings=()
    shift
    command -v cmake >/dev/null || fail "$machine_lacks" "needs CMake 3.22 or newer, Ninja and a compiler for C++20"
    local up_to_date=yes
    [[ -f $cache && -f $root/build/$preset/build.ninja && $packages_changed == no ]] || up_to_date=no
    for setting in "$@"; do
        settings+=("-D$setting")
        grep -qs "^${setting%%=*}:[A-Z]*=${setting#*=}\$" "$cache" || up_to_date=no
    done
    [[ $up_to_date == yes ]] && return 0
    logged "configuring" cmake -S "$root" --preset "$preset" "${settings[@]}" || fail 1 "CMake could not configure build/$preset"
}

# test_environment PRESET: a quiet one for the tests, which make their own screens and choose their own drivers and languages.
test_environment() {
    local folder=$root/build/$1
    # A second locale with a decimal comma, kept in the build folder.
    if command -v localedef >/dev/null && [[ ! -d $folder/locale/de_DE.UTF-8 && -f /usr/share/i18n/locales/de_DE ]]; then
        mkdir -p "$folder/locale"
        localedef --no-archive -i de_DE -f UTF-8 "$folder/locale/de_DE.UTF-8"
    fi
    unset DISPLAY WAYLAND_DISPLAY GALLIUM_DRIVER LIBGL_ALWAYS_SOFTWARE LIBGL_DRIVERS_PATH MESA_LOADER_DRIVER_OVERRIDE LANG LANGUAGE
    export LC_ALL=C.UTF-8 LOCPATH=$folder/locale
    # Without a folder for sockets Mesa 25 complains on standard error.
    mkdir -p "$folder/runtime" && chmod 700 "$folder/runtime"
    export XDG_RUNTIME_DIR=$folder/runtime
    export LSAN_OPTIONS=suppressions=$root/tests/leaks.txt:print_suppressions=0
    export TSAN_OPTIONS=suppressions=$root/tests/races.txt
}

# build PRESET TARGET...
build() {
    local preset=$1
    shift
    [[ -e $root/build/$preset/.ninja_log ]] || say "building; the first time takes a few minutes"
    logged "building" cmake --build "$root/build/$preset" --parallel "$(getconf _NPROCESSORS_ONLN)" --target "$@" ||
        fail 1 "could not be built"
}
