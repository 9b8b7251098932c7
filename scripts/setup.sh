# shellcheck shell=bash
# Shared by ./run and ./test: packages, configuration, build. Sourced, with `root` set to the repository's folder.
# Standard output is left to the program that runs afterwards: messages go to standard error, and the output of apt,
# cmake and ninja goes to a log that is shown only if a step fails.

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

# fail_with_log MESSAGE: prints the end of the log, then the message.
fail_with_log() {
    tail -n 60 "$log" >&2
    fail "$1; whole log: $log"
}

# Serialises set-ups that are started at the same time.
lock_setup() {
    mkdir -p "$root/build"
    exec {setup_lock}>"$root/build/setup.lock"
    flock "$setup_lock"
}

# Called before the program starts, which may run for hours.
unlock_setup() {
    exec {setup_lock}>&-
}

listed_packages() {
    sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/scripts/packages.txt"
}

# Checked on each run, which takes 20 ms: a stamp file would be wrong if the build folder is moved to another machine.
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
    # Ignored: one broken package source does not matter if the others have the packages.
    "${as_root[@]}" "${apt[@]}" update >"$log" 2>&1 || true
    "${as_root[@]}" "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1 ||
        fail_with_log "apt-get cannot install ${missing[*]}"
}

configure() {
    local cache=$build_folder/CMakeCache.txt
    # A copied or moved checkout has a cache for another folder, which cmake refuses.
    if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
        rm -rf "$build_folder"
    fi
    if [[ -f $build_folder/build.ninja ]]; then
        return
    fi
    say "configuring"
    (cd "$root" && cmake --preset release) >"$log" 2>&1 || fail_with_log "cmake --preset release failed"
}

# Copies ninja's output to the log and shows it as one line that is updated, or as one line without a terminal.
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

# ccache keeps what it has where it always does, but beside the build where that can't be written.
choose_compiler_cache() {
    local usual=${CCACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/ccache}
    if ! mkdir -p "$usual" 2>/dev/null || [[ ! -w $usual ]]; then
        export CCACHE_DIR=$root/build/ccache
    fi
}

# build TARGET...
build() {
    choose_compiler_cache
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
