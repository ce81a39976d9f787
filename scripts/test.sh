#!/usr/bin/env bash
# Builds weft and runs its tests, in every way this machine can.
# usage: scripts/test.sh [--quick | STAGE...]
#   --quick  only the release build and all of its tests
#   STAGE    only these, for example: scripts/test.sh asan tsan
# Stages: setup, docs (needs mkdocs), release, cuda (needs nvcc), hip (needs hipcc), packaging,
# debug, and clang, asan and tsan (need clang++). A stage that fails does not stop the next one; the
# script fails if any of them did.
# shellcheck disable=SC2317  # the stages are called by name
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/stages.sh

jobs=${JOBS:-$(nproc)}
export OMP_WAIT_POLICY=passive  # a waiting thread must not take the core of one that works
export CTEST_PARALLEL_LEVEL=$jobs

have() { command -v "$1" >/dev/null; }
have_nvcc() { have nvcc || [[ -x "${CUDA_HOME:-/usr/local/cuda}/bin/nvcc" ]]; }

configure() {  # PRESET [-D...]
  cmake --preset "$1" -DWEFT_WARNINGS_AS_ERRORS=ON "${@:2}"
}

compile() {  # PRESET [TARGET...]; a folder's targets are FOLDER/all
  local targets=()
  [[ $# -eq 1 ]] || targets=(--target "${@:2}")
  cmake --build "build/$1" --parallel "$jobs" "${targets[@]}"
}

run_tests() {  # PRESET [ctest options]
  local log="build/$1/ctest.log"
  ctest --preset "$1" "${@:2}" 2>&1 | tee "$log"
  keep_summary "$1" "$log"
}

# The bits of a run do not depend on compiler, optimisation or device.
same_bits() {  # PRESET TOOL_OPTIONS...
  local scene name want got
  if [[ ! -x build/release/tools/weft ]]; then
    configure release
    compile release weft_cli
  fi
  for scene in samples/scenes/*.json; do
    name=$(basename "$scene" .json)
    want=$(state_hash release "$scene" --backend omp)
    got=$(state_hash "$@" "$scene")
    echo "$name: release $want, $1 $got"
    if [[ "$want" != "$got" ]]; then
      echo "$1 gives other bits than release on $scene" >&2
      return 1
    fi
  done
}

state_hash() {  # PRESET [TOOL_OPTIONS...] SCENE [...]: after half a second
  local report
  report=$(mktemp)
  "build/$1/tools/weft" run --time 0.5 --report "$report" "${@:2}" >/dev/null
  python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["state_hash"])' "$report"
  rm -f "$report"
}

setup() {
  scripts/setup.sh "${setup_options[@]}"
}

# The site of the documents, every link followed.
docs() {
  scripts/docs.sh
}

release() {
  configure release
  compile release
  run_tests release
}

cuda() {
  configure cuda -DCMAKE_CUDA_ARCHITECTURES="${CUDA_ARCHITECTURES:-80}"
  # As far as a machine without a GPU can: packages, and the build of all that the check runs.
  scripts/gpu_check.sh --again --build build/cuda prepare build
  run_tests cuda -R '^hygiene[.]no_spills$'
  if ! nvidia-smi >/dev/null 2>&1; then
    check_fallback cuda
  fi
  same_bits cuda
}

# Nobody has run this one on an AMD GPU yet.
hip() {
  configure hip
  compile hip weft_cli
  if [[ ! -e /dev/kfd ]]; then
    check_fallback hip
  fi
  same_bits hip
}

# Without a usable GPU the program starts, says so in one line and runs on the host.
check_fallback() {  # PRESET
  local scene said
  scene=$(find samples/scenes -name '*.json' | sort | head -n 1)
  said=$("build/$1/tools/weft" run "$scene" --time 0.1 2>&1 | grep 'GPU is not used' || true)
  echo "$1 without a GPU: $said"
  if [[ $(grep -c . <<<"$said") -ne 1 ]]; then
    echo "one line about the fallback was expected" >&2
    return 1
  fi
}

# LLVM's OpenMP runtime leaves a file behind where its process was killed, and trips over an empty
# one that an earlier process of the same number left.
forget_dead_teams() {
  local file pid
  for file in /dev/shm/__KMP_REGISTERED_LIB_*; do
    pid=${file##*LIB_}
    pid=${pid%%_*}
    [[ ! -e "$file" || -d "/proc/$pid" ]] || rm -f "$file"
  done
}

# Every way of taking weft into another project, and its Debian packages.
packaging() {
  if [[ ! -e build/release/src/libweft.a ]]; then
    configure release
    compile release weft
  fi
  configure shared
  compile shared weft weft_cli
  python3 -B tests/packaging/consumers.py . build/release build/shared
}

clang() {
  configure clang
  compile clang weft_cli tests/determinism/all
  forget_dead_teams
  run_tests clang -L determinism
  same_bits clang
}

debug() {
  configure debug
  compile debug weft_cli tests/determinism/all
  run_tests debug -R '^(Golden|Hash)[.]'
  same_bits debug
}

asan() {
  configure asan
  local pictures=()  # as far as there are packages to draw them with
  [[ ! -e build/asan/tests/render/CTestTestfile.cmake ]] || pictures=(tests/render/all)
  compile asan weft_cli tests/{unit,kernels,api,backend,io,fuzz,stability}/all "${pictures[@]}"
  forget_dead_teams
  run_tests asan -L '^(unit|kernels|api|backend|io|render|fuzz|stability)$' -LE long
}

# The OpenMP runtime is not instrumented; its archer library tells the sanitizer of its barriers.
tsan() {
  configure tsan
  compile tsan race weft_tests_threads tests/determinism/all
  forget_dead_teams
  run_tests tsan -L '^(determinism|race)$' -LE long
}

setup_options=(--all)
all=(setup docs release cuda hip packaging clang debug asan tsan)
case "${1:-}" in
  "") wanted=("${all[@]}") ;;
  --quick) wanted=(setup release) setup_options=() ;;
  *) wanted=("$@") ;;
esac
for name in "${wanted[@]}"; do
  if [[ " ${all[*]} " != *" $name "* ]]; then
    echo "test: $name is not a stage; usage: scripts/test.sh [--quick | STAGE...] of ${all[*]}" >&2
    exit 2
  fi
done

for name in "${wanted[@]}"; do
  case $name in
    docs) stage_if "have mkdocs" "mkdocs is missing" docs docs ;;
    cuda) stage_if have_nvcc "nvcc is missing" cuda cuda ;;
    packaging) stage_if "have pkg-config" "pkg-config is missing" packaging packaging ;;
    hip) stage_if "have hipcc" "hipcc is missing" hip hip ;;
    clang | asan | tsan) stage_if "have clang++" "clang++ is missing" "$name" "$name" ;;
    *) stage "$name" "$name" ;;
  esac
done
finish
