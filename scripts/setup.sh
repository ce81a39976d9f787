#!/usr/bin/env bash
# Installs what weft needs to be built and tested on Debian 12 or a relative of it.
# usage: scripts/setup.sh [--all | --demo]
#   --all   also clang with its OpenMP and sanitizer runtimes, hipcc with rocPRIM, pkg-config and
#          mkdocs, for the other stages of test.sh, and ccache
#   --demo  also ffmpeg, for the films of demo.sh, and gnuplot, for the plots of pages
# Says what it installs, and does nothing (in a fraction of a second) when nothing is missing.
set -euo pipefail

packages=()   # what the build and the tests need
extras=()     # what only --all asks for

need_command() {  # COMMAND PACKAGE: a tool may come from anywhere, not only from its package
  command -v "$1" >/dev/null || packages+=("$2")
}
need_package() {  # PACKAGE...
  local package
  for package in "$@"; do
    is_installed "$package" || packages+=("$package")
  done
}
is_installed() {
  [[ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

have_thrust() {  # the CUDA toolkit's copy; the build looks in the same places
  local root
  for root in "${CUDA_HOME:-}" "${CUDA_PATH:-}" /usr/local/cuda; do
    [[ -n "$root" ]] || continue
    if [[ -e "$root/include/cccl/thrust/sort.h" || -e "$root/include/thrust/sort.h" ]]; then
      return 0
    fi
  done
  return 1
}

install() {
  echo "setup: installing $*"
  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "setup: cannot install (this user is not root and there is no sudo)." \
           "As root, run: apt-get install $*" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "$@"
}

if [[ $# -gt 1 || ( $# -eq 1 && "$1" != --all && "$1" != --demo ) ]]; then
  echo "setup: usage: scripts/setup.sh [--all | --demo]" >&2
  exit 2
fi
if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: this is not a Debian system (no apt-get). Install by hand: a C++20 compiler," \
       "CMake 3.25, Ninja, git, Python 3, binutils, Valgrind, GoogleTest, Eigen, nlohmann-json," \
       "CLI11, Thrust with CUB, and (optional) the Assimp test models, libepoxy, EGL, libpng," \
       "ffmpeg, gnuplot" >&2
  exit 1
fi

need_command g++ g++
need_command cmake cmake
need_command ninja ninja-build
need_command git git
need_command python3 python3
need_command nm binutils
need_command valgrind valgrind
need_package libgtest-dev libeigen3-dev nlohmann-json3-dev libcli11-dev assimp-testmodels
need_package libepoxy-dev libegl-dev libegl1 libgl1-mesa-dri libpng-dev  # pictures
have_thrust || need_package libthrust-dev libcub-dev
if [[ "${1:-}" == --all ]]; then
  for package in clang libclang-rt-14-dev libomp-dev llvm \
                 hipcc libamdhip64-dev rocm-device-libs librocprim-dev dpkg-dev pkg-config \
                 mkdocs ccache; do
    is_installed "$package" || extras+=("$package")
  done
fi

if [[ "${1:-}" == --demo ]]; then
  command -v ffmpeg >/dev/null || extras+=(ffmpeg)
  command -v gnuplot >/dev/null || extras+=(gnuplot-nox)
fi

if [[ ${#packages[@]} -eq 0 && ${#extras[@]} -eq 0 ]]; then
  echo "setup: nothing is missing"
  exit 0
fi
if [[ ${#packages[@]} -gt 0 ]]; then
  install "${packages[@]}"
fi
if [[ ${#extras[@]} -gt 0 ]] && ! install "${extras[@]}"; then
  echo "setup: going on without ${extras[*]}" \
       "(only some stages of test.sh, or the films of demo.sh, need them)" >&2
fi
