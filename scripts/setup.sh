# shellcheck shell=bash
# What ./run and ./test share: packages, configuration, build. Sourced, with `root` set to the repository's folder.
# Standard output belongs to the program that runs afterwards: everything here speaks on standard error, and the words
# of apt, cmake and ninja go to a log that is shown only where a step fails.

: "${root:?set by the script that sources this one}"
build_folder=$root/build/release
log=$root/build/setup.log

say() {
    printf 'timeshade: %s\n' "$*" >&2
}

fail() {
    say "error: $*"
    exit 1
}

# fail_with_log MESSAGE: the end of the log, then the message.
fail_with_log() {
    tail -n 60 "$log" >&2
    fail "$1; whole log: $log"
}

# One step at a time, also where two terminals start together.
lock_setup() {
    mkdir -p "$root/build"
    exec {setup_lock}>"$root/build/setup.lock"
    flock "$setup_lock"
}

# The program that follows may run for hours and must not hold the lock.
unlock_setup() {
    exec {setup_lock}>&-
}

listed_packages() {
    sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/scripts/packages.txt"
}

# Asked anew each time, which takes 20 ms: a stamp would lie where the build folder outlives the machine.
missing_packages() {
    local packages
    mapfile -t packages < <(listed_packages)
    comm -23 <(printf '%s\n' "${packages[@]}" | sort) \
        <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null |
            sed -n 's/^installed //p' | sort -u)
}

install_packages() {
    if ! command -v dpkg-query >/dev/null; then
        say "no dpkg on this machine: scripts/packages.txt says what is needed, expected Debian 12"
        return
    fi
    local missing as_root=()
    mapfile -t missing < <(missing_packages)
    if ((${#missing[@]} == 0)); then
        return
    fi
    if ((EUID != 0)); then
        # Without a terminal sudo cannot ask for a password.
        if ! command -v sudo >/dev/null || { [[ ! -t 0 ]] && ! sudo -n true 2>/dev/null; }; then
            fail "packages are missing and there is neither root nor sudo to install them: ${missing[*]}"
        fi
        as_root=(sudo)
    fi
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    local apt=(apt-get -qq -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300)
    say "installing ${#missing[@]} Debian packages of scripts/packages.txt"
    # One broken source among many does not matter if the packages can be had from the others.
    "${as_root[@]}" "${apt[@]}" update >"$log" 2>&1 || true
    "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1 ||
        fail_with_log "apt-get cannot install ${missing[*]}"
}

configure() {
    local cache=$build_folder/CMakeCache.txt
    # A copied or moved checkout brings a cache that speaks of another folder, and cmake refuses it.
    if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
        rm -rf "$build_folder"
    fi
    if [[ -f $build_folder/build.ninja ]]; then
        return
    fi
    say "configuring"
    (cd "$root" && cmake --preset release) >"$log" 2>&1 || fail_with_log "cmake --preset release failed"
}

# Copies ninja's words to the log and turns them into one moving line, or into one line where nobody watches.
show_progress() {
    local line progress=""
    while IFS= read -r line; do
        printf '%s\n' "$line"
        if [[ $line =~ ^\[([0-9]+/[0-9]+)\] && $line != *'Re-checking globbed directories'* ]]; then
            if [[ -t 2 ]]; then
                printf '\rtimeshade: building %s\033[K' "${BASH_REMATCH[1]}" >&2
            elif [[ -z $progress ]]; then
                say "building"
            fi
            progress=${BASH_REMATCH[1]}
        fi
    done
    if [[ -n $progress && -t 2 ]]; then
        printf '\r\033[K' >&2
    fi
}

# build TARGET...
build() {
    ninja -C "$build_folder" -j "$(nproc)" "$@" 2>&1 | show_progress >"$log" || fail_with_log "the build failed"
}

# set_up TARGET...: packages, configuration, and a build of the targets.
set_up() {
    lock_setup
    install_packages
    configure
    build "$@"
    unlock_setup
}
