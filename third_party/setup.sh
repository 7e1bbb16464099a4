# What `run` and `test` share: installing the packages of packages.txt, configuring, building quietly.
# Sourced by them with GLINT_ROOT set. Nothing here may take noticeable time when there is nothing to do.

say() { printf 'glint: %s\n' "$*"; }
fail() { printf 'glint: %s\n' "$*" >&2; exit 1; }

# listPackages SECTION…: the packages of these sections, one a line.
listPackages() {
    awk -v wanted=" $* " '
        { sub(/#.*/, "") }
        /^\[/ { gsub(/[][ ]/, ""); inside = index(wanted, " " $0 " "); next }
        NF && inside { print $1 }' "$GLINT_ROOT/third_party/packages.txt"
}

# Asking dpkg takes longer than an up-to-date build, so a stamp remembers the list that was complete.
ensurePackages() {
    local stamp packages
    stamp="$GLINT_ROOT/build/.packages-$(IFS=-; echo "$*")"
    if [[ -e $stamp && ! "$GLINT_ROOT/third_party/packages.txt" -nt $stamp ]]; then return; fi
    mapfile -t packages < <(listPackages "$@")

    if command -v dpkg-query >/dev/null; then
        installMissing "${packages[@]}"
    else
        say "this is not a Debian system; the build needs the equivalents of these packages: ${packages[*]}"
    fi
    mkdir -p "$GLINT_ROOT/build"
    touch "$stamp"
}

installMissing() {
    local missing
    missing=$({ dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true; } |
        awk '$1 == "installed" { print $2 }' | sort | comm -13 - <(printf '%s\n' "$@" | sort) | tr '\n' ' ')
    if [[ -n $missing ]]; then installPackages $missing; fi
}

installPackages() {
    local asRoot=()
    if ((EUID != 0)); then
        if ! sudo -n true 2>/dev/null; then
            say "some packages are missing. Install them with this command, then start again:" >&2
            echo "sudo apt-get install --no-install-recommends $*" >&2
            exit 1
        fi
        asRoot=(sudo -n)
    fi
    say "installing $*"
    local log="$GLINT_ROOT/build/packages.log"
    mkdir -p "$GLINT_ROOT/build"
    if ! { "${asRoot[@]}" apt-get update &&
           "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive \
               apt-get install --yes --no-install-recommends "$@"; } >"$log" 2>&1; then
        cat "$log" >&2
        fail "the packages could not be installed"
    fi
}

# build PRESET [TARGET…]: configures when there is no build folder yet (Ninja reconfigures by itself later) and
# builds. Silent when nothing is to be done; the compiler's output is shown only when it fails.
# CUDA's kernels take a third of the time. The program alone has them where a card can use them; tests compile them.
build() {
    local preset=$1 dir="$GLINT_ROOT/build/$1" log="$GLINT_ROOT/build/$1.log" started=$SECONDS options=()
    shift
    mkdir -p "$dir"
    if [[ ! -e $dir/build.ninja ]]; then
        if [[ $* == glint ]]; then options=(-DGLINT_CUDA=CARD); fi
    elif [[ $* != glint ]] && grep -q '^GLINT_CUDA:.*=CARD$' "$dir/CMakeCache.txt"; then
        options=(-DGLINT_CUDA=AUTO)
    fi
    if [[ ! -e $dir/build.ninja || ${#options[@]} -gt 0 ]]; then
        say "configuring $preset"
        if ! (cd "$GLINT_ROOT" && cmake --preset "$preset" "${options[@]}") >"$log" 2>&1; then
            cat "$log" >&2
            fail "configuring $preset failed"
        fi
    fi
    if ! ninja -C "$dir" "$@" 2>&1 | tee "$log" | showProgress "$preset"; then
        cat "$log" >&2
        fail "building $preset failed"
    fi
    if grep -qE "$buildStep" "$log"; then say "built $preset in $((SECONDS - started)) s"; fi
}

buildStep='^\[([0-9]+)/([0-9]+)\] (Building|Linking)'

# Reads Ninja's output: a line at the start and, on a terminal, one that counts up.
showProgress() {
    local line steps=""
    while IFS= read -r line; do
        [[ $line =~ $buildStep ]] || continue
        if [[ -z $steps ]]; then say "building $1 (${BASH_REMATCH[2]} steps)"; fi
        steps="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
        if [[ -t 1 ]]; then printf '\rglint: %s ' "$steps"; fi
    done
    if [[ -n $steps && -t 1 ]]; then printf '\r'; fi
}
