# Shared by the scripts: messages, packages, workspace. Source it; needs bash.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
# Not below the checkout: ROS would find every launch file and program of the package a second time there.
workspace=${MIXED_PALLETIZING_WORKSPACE:-${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/mixed_palletizing/ws-$(printf %s "$root" | cksum | cut -d' ' -f1)}
jobs=${MIXED_PALLETIZING_JOBS:-2}

say() { printf '\033[1m== %s\033[0m\n' "$*" >&2; }
die() { printf 'error: %s\n' "$*" >&2; exit 1; }

# Noetic lives below /opt/ros on Ubuntu; Debian has it under /usr.
noetic=/opt/ros/noetic/setup.bash

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo "$@"
  else die "root rights are needed for: $* (no sudo here; run it yourself, then repeat)"
  fi
}

# install_packages LIST...: installs what is missing of the Debian packages named in scripts/packages/LIST.txt.
install_packages() {
  if [ -f "$noetic" ]; then install_packages_noetic; return; fi
  command -v apt-get >/dev/null || die "no apt-get here: Debian bookworm, or Ubuntu 20.04 with ROS Noetic, is needed"
  local wanted missing
  wanted=$(for list in "$@"; do grep -v '^#' "$root/scripts/packages/$list.txt"; done | sort -u)
  missing=$(comm -13 <(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' | awk '$1 == "ii" {print $2}' | sort -u) \
    <(printf '%s\n' "$wanted"))
  [ -n "$missing" ] || return 0
  say "installing $(printf '%s\n' "$missing" | wc -l) Debian packages with apt-get, which may take some minutes"
  printf '%s\n' "$missing" | paste -sd' ' | fold -s -w 110 >&2
  as_root apt-get update -qq
  # shellcheck disable=SC2086
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null ||
    die "apt-get could not install the packages above"
}

install_packages_noetic() {
  # shellcheck disable=SC1090
  . "$noetic"
  command -v rosdep >/dev/null || die "rosdep is missing: apt-get install python3-rosdep, then rosdep init && rosdep update"
  say "installing what rosdep finds missing"
  rosdep install --from-paths "$root" --ignore-src -y --rosdistro noetic || die "rosdep could not install the dependencies"
}

# show_progress LOG: how far the build is that writes it, until this process or its shell ends.
show_progress() {
  while kill -0 $$ 2>/dev/null; do
    printf '\r%s ' "$(grep -o '^\[ *[0-9]*%\]' "$1" 2>/dev/null | tail -n 1)" >&2
    sleep 1
  done
}

# make_workspace [TARGET...]: configures and builds the catkin workspace around this checkout.
make_workspace() {
  export PATH=/usr/bin:$PATH  # ROS' Python modules belong to the system's python3
  # catkin writes the tests' PYTHONPATH while it configures, and leaves out folders that do not exist by then
  mkdir -p "$workspace/src" "$workspace/devel/lib/python3/dist-packages"
  ln -sfn "$root" "$workspace/src/mixed_palletizing"
  local log="$workspace/build.log" target progress code
  [ -d "$workspace/build" ] || say "the first build takes some minutes; its log is $log"
  say "building in $workspace"
  for target in "${@:-all}"; do
    : >"$log"
    progress='' code=0
    if [ -t 2 ]; then show_progress "$log" & progress=$!; fi
    (cd "$workspace" && catkin_make -j"$jobs" \
      -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
      -DCATKIN_ENABLE_TESTING="${CATKIN_ENABLE_TESTING:-OFF}" "$target") >"$log" 2>&1 || code=$?
    if [ -n "$progress" ]; then
      kill "$progress" && wait "$progress" 2>/dev/null || true
      printf '\r      \r' >&2
    fi
    [ "$code" -eq 0 ] ||
      { grep -E -A6 'error|Error' "$log" | head -n 60 >&2 || true; die "the build failed; the whole log is $log"; }
  done
}

# use_workspace [devel|install]: puts the built package on the paths of this shell.
use_workspace() {
  # The generated script reads variables that may be unset.
  set +u
  # shellcheck disable=SC1090,SC1091
  . "$workspace/${1:-devel}/setup.bash"
  set -u
  export PATH=/usr/bin:$PATH
}

# use_libraries_of BUILD PROGRAM...: a shell that uses a workspace finds the workspace's libraries first, not those that were built with
# the programs; from here on it finds the latter, and the programs are looked at.
use_libraries_of() {
  local build=$1 program others
  shift
  export LD_LIBRARY_PATH=$build/devel/lib:${LD_LIBRARY_PATH:-}
  for program in "$@"; do
    others=$(ldd "$program" | awk '/libmixed_palletizing/ {print $3}' | grep -vF "$build/devel/lib/" || true)
    [ -z "$others" ] || die "$program takes ${others//$'\n'/, } instead of the libraries of $build"
  done
}

# free_port: a TCP port nobody listens on.
free_port() {
  /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}
