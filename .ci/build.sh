# What ./af2 and ./check share: installing packages and building. Sourced by bash; wants $root.
# Everything that is told goes to stderr, so that stdout belongs to the program.

say() { printf 'af2: %s\n' "$*" >&2; }

# packages_for build|check: the packages of packages.txt, one a line.
packages_for() {
  local everything=0
  [ "$1" = check ] && everything=1
  awk -v everything=$everything '
    /^\[check\]/ { check = 1; next }
    /^[a-z0-9]/ && (everything || !check) { print $1 }' "$root/packages.txt"
}

# missing_packages NAME...: those that are not installed.
missing_packages() {
  local known installed
  known=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null) || true
  installed=$(awk '$1 == "installed" { print $2 }' <<<"$known")
  comm -23 <(printf '%s\n' "$@" | sort -u) <(printf '%s\n' "$installed" | sort -u)
}

# as_root COMMAND...: never waits for a password that nobody can type.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"
  elif [ -t 0 ] && [ -z "${CI:-}" ]; then sudo "$@"
  else sudo -n "$@"
  fi
}

# how_far LOG: what ninja or apt-get has come to, in a word or two; nothing if that cannot be told.
how_far() {
  awk '
    match($0, /^\[[0-9]+\/[0-9]+\]/) {
      split(substr($0, 2, RLENGTH - 2), n, "/"); done = n[1]; all = n[2]; step = "compiled" }
    /newly installed/ { for (i = 1; i < NF; ++i) if ($(i + 1) == "newly") all = $i }
    /^Get:/ { step = "downloaded"; ++downloads; done = downloads }
    /^Unpacking / { step = "unpacked"; ++unpacked; done = unpacked }
    /^Setting up / { step = "set up"; ++ready; done = ready }
    END { if (all > 0 && step != "") {
      share = int(10 * done / all) * 10
      if (share > 100) share = 100
      printf "%s %d %%", step, share } }' "$1" 2>/dev/null
}

# run_logged LOG WHAT COMMAND...: runs it with its output in LOG, and says about every tenth how far it is.
run_logged() {
  local log=$1 what=$2 told='' now pid
  shift 2
  "$@" </dev/null >"$log" 2>&1 &
  pid=$!
  while kill -0 "$pid" 2>/dev/null; do
    sleep 1
    now=$(how_far "$log")
    if [ -n "$now" ] && [ "$now" != "$told" ]; then say "$what: $now"; told=$now; fi
  done
  wait "$pid"
}

# apt_install NAME...
apt_install() {
  local log status=0
  log=$(mktemp)
  # An update that fails may still leave lists that are good enough.
  as_root apt-get update </dev/null >"$log" 2>&1 || true
  run_logged "$log" packages \
    as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y --no-install-recommends -o Dpkg::Use-Pty=0 "$@" || status=1
  [ "$status" -eq 0 ] || tail -n 15 "$log" >&2
  rm -f "$log"
  return "$status"
}

# install_packages build|check
install_packages() {
  command -v dpkg-query >/dev/null || return 0  # not Debian: CMake says what it does not find
  local wanted missing
  mapfile -t wanted < <(packages_for "$1")
  mapfile -t missing < <(missing_packages "${wanted[@]}")
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    say "these Debian packages are missing: ${missing[*]}"
    say "install them as root: apt-get install --no-install-recommends ${missing[*]}"
    exit 1
  fi
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  if ! apt_install "${missing[@]}"; then
    say "apt-get could not install them (see above). Without network or rights, let somebody run:"
    say "  apt-get install --no-install-recommends ${missing[*]}"
    exit 1
  fi
}

# Compiling takes up to about 2 GB at once.
jobs_that_fit() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 2000000) }' /proc/meminfo)
  [ "$memory" -lt 1 ] && memory=1
  echo $((cores < memory ? cores : memory))
}

# configure [-D...]: makes build/, or changes its settings.
configure() {
  local log="$root/build/configure.log" launcher=()
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  if ! cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${launcher[@]}" "$@" \
      </dev/null >"$log" 2>&1; then
    cat "$log" >&2
    say "CMake could not configure AF2 (see above)"
    exit 1
  fi
}

# Warnings are errors with the compiler that AF2 is developed with, a newer one may have new warnings.
warnings_setting() {
  if grep -qs '^VERSION_ID="12"' /etc/os-release; then echo ON; else echo OFF; fi
}

# build TARGET: silent if nothing is to be done.
build() {
  local log="$root/build/build.log" command
  export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1
  if ninja -C "$root/build" -n "$1" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
  command=(ninja -C "$root/build" -j "$(jobs_that_fit)" "$1")
  if [ -t 2 ]; then
    NINJA_STATUS='af2: building [%f/%t] ' "${command[@]}" </dev/null >&2 && return 0
  else
    say "building; the first time this takes some minutes (log: $log)"
    run_logged "$log" building env NINJA_STATUS='[%f/%t] ' "${command[@]}" && return 0
    grep -v '^\[' "$log" | tail -n 60 >&2
  fi
  say "AF2 could not be built (see above)"
  exit 1
}

# with_build_lock COMMAND...: two runs must not build at once.
with_build_lock() {
  exec 9>"$root/build/.lock"
  flock 9
  "$@"
  exec 9>&-
}
