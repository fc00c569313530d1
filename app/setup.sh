# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by app/run and tests/run: installs what is missing, configures and builds.

# What building and running takes on Debian 12. Everything else is a dependency of these.
build_packages=(build-essential cmake ninja-build ccache mold pkg-config
  qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools
  libcgal-dev libopenmesh-dev libvtk9-dev libeigen3-dev libassimp-dev libgdal-dev libzip-dev libhidapi-dev zlib1g-dev libexpected-dev libcli11-dev fonts-dejavu-core qt6-translations-l10n)
# What a machine without a display needs on top, to draw into a virtual one.
virtual_display_packages=(xvfb xauth libgl1-mesa-dri)
# The player page: its decoder is WebAssembly. Node.js is asked for by its commands, as it often comes from elsewhere.
web_packages=(clang-14 lld-14 wasi-libc libc++-14-dev-wasm32 libclang-rt-14-dev-wasm32)
command -v node >/dev/null || web_packages+=(nodejs)
command -v npm >/dev/null || web_packages+=(npm)

say() { printf '%s\n' "== $*" >&2; }

# Installs those of the packages that are missing; without the right to, prints the line that does.
require_packages() {
  local missing=() package
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "This is not Debian: make sure that you have what these Debian packages hold: $*"
    return
  fi
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    say "Some packages are missing. Install them with this line and start again:"
    printf '%s\n' "sudo apt-get install -y --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  say "Installing through apt: ${missing[*]}"
  apt-get update -qq
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build PRESET [TARGET...]: configures if need be, and builds; says how long it took.
build() {
  local preset=$1 begin=$SECONDS
  shift
  say "Building ($preset)"
  mkdir -p build
  if ! cmake --preset "$preset" >"build/configure-$preset.log" 2>&1; then
    cat "build/configure-$preset.log" >&2
    return 1
  fi
  cmake --build --preset "$preset" --parallel "$(nproc)" ${1:+--target "$@"} >&2
  say "Built ($preset) in $((SECONDS - begin)) s"
}

# The page that sandreel-cli export-player copies, in build/web/player.
build_player() {
  local begin=$SECONDS
  build web decoder || return 1
  say "Building the player page"
  if ! (cd app/web && { [ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-progress >&2; }); then
    say "npm could not install what app/web/package-lock.json names. Without a network, fill npm's cache before."
    return 1
  fi
  (cd app/web && node node_modules/typescript/bin/tsc --noEmit &&
    node build.mjs ../../build/web/decoder.wasm ../../build/web/player) >&2 || return 1
  say "Built the player page in $((SECONDS - begin)) s"
}

has_display() { [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; }

# Runs a command in a virtual display of its own and returns what it returns.
in_virtual_display() {
  local folder server status=0 tries=0
  folder=$(mktemp -d)
  # The server picks a free number and says which; xvfb-run guesses one, and fails now and then when it tidies up.
  Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$folder/number" 2>"$folder/log" &
  server=$!
  until [ -s "$folder/number" ]; do
    if ! kill -0 "$server" 2>/dev/null || [ $((tries += 1)) -gt 300 ]; then
      say "The virtual display did not start:"
      cat "$folder/log" >&2
      rm -rf "$folder"
      return 1
    fi
    sleep 0.1
  done
  mkdir -m 700 "$folder/runtime"
  DISPLAY=:$(cat "$folder/number") XDG_RUNTIME_DIR=$folder/runtime "$@" || status=$?
  kill "$server" 2>/dev/null
  wait "$server" 2>/dev/null || true
  rm -rf "$folder" || true
  return "$status"
}
