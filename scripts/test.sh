#!/usr/bin/env bash
# Builds weft and runs its tests, in every way this machine can.
# usage: scripts/test.sh [--quick | STAGE...]
#   --quick  only an optimised build for the host and all of its tests, in build/quick
#   STAGE    only these, for example: scripts/test.sh asan tsan
# Stages: setup, docs (needs mkdocs), release, cuda (needs nvcc), hip (needs hipcc), packaging,
# debug, quick, and clang, asan and tsan (need clang++); all but quick run by default. A stage that
# fails does not stop the next one; the script fails if any of them did.
#
# release compiles each file alone, with the CUDA back end where there is nvcc. The other stages
# compile the files of a folder as one; hip and packaging take the host's kernels from release.
# shellcheck disable=SC2317  # the stages are called by name
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/stages.sh

jobs=${JOBS:-$(nproc)}
export OMP_WAIT_POLICY=passive  # a waiting thread must not take the core of one that works
export CTEST_PARALLEL_LEVEL=$jobs

have() { command -v "$1" >/dev/null; }

configure() {  # PRESET [-D...]
  cmake --preset "$1" -DWEFT_WARNINGS_AS_ERRORS=ON "${@:2}"
}

unity=(-DCMAKE_UNITY_BUILD=ON)
bare=(-DWEFT_BUILD_BENCH=OFF -DWEFT_BUILD_PICTURES=OFF)  # what others of g++ compile already
kernels_of_release=(-DWEFT_KERNELS_FROM=build/release)

configure_release() {
  if have_nvcc; then
    configure cuda -B build/release -DCMAKE_CUDA_ARCHITECTURES="$(cuda_architecture)"
  else
    configure release
  fi
}

compile_release() {  # [TARGET...]
  configure_release
  compile release "$@"
}

compile_kernels() {
  compile_release weft_omp_v2 weft_omp_v3 weft_omp_v4
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

# The bits of a run do not depend on compiler, optimisation, instruction level or device.
same_bits() {  # PRESET TOOL_OPTIONS...
  local scene name want got
  compile_release weft_cli
  for scene in samples/scenes/*.json; do
    name=$(basename "$scene" .json)
    want=$(state_hash release "$scene" --backend omp --isa v2)
    got=$(state_hash "$@" "$scene")
    echo "$name: host of release $want, $1 $got"
    if [[ "$want" != "$got" ]]; then
      echo "$1 gives other bits than the host of release on $scene" >&2
      return 1
    fi
  done
}

# After half a second; of the largest scene, which would take an hour at -O0, after two frames.
state_hash() {  # PRESET [TOOL_OPTIONS...] SCENE
  local report time=0.5
  [[ "$*" != */fold.json* ]] || time=0.016
  report=$(mktemp)
  "build/$1/tools/weft" run --time "$time" --report "$report" "${@:2}" >/dev/null
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
  compile_release
  run_tests release
}

quick() {
  configure quick
  compile quick
  run_tests quick
}

# What a machine without a GPU can check of release's CUDA back end: packages, the build of all that
# the check of a machine with one runs, and the host instead.
cuda() {
  configure_release
  WARNINGS_AS_ERRORS=ON scripts/gpu_check.sh --again --build build/release prepare build
  run_tests release -R '^hygiene[.]no_spills$'
  if ! nvidia-smi >/dev/null 2>&1; then
    check_fallback release
  fi
  same_bits release
}

# Nobody has run this one on an AMD GPU yet.
hip() {
  compile_kernels
  configure hip "${unity[@]}" "${bare[@]}" "${kernels_of_release[@]}"
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
  compile_kernels
  configure release -B build/static "${unity[@]}" "${bare[@]}" "${kernels_of_release[@]}" \
    -DWEFT_BUILD_TOOLS=OFF -DWEFT_BUILD_TESTS=OFF -DWEFT_BUILD_SAMPLES=OFF
  compile static weft
  python3 -B tests/hygiene/cpu_library.py nm build/static/src/libweft.a
  configure shared "${unity[@]}" "${kernels_of_release[@]}" -DWEFT_BUILD_TESTS=OFF
  compile shared weft weft_cli
  python3 -B tests/packaging/consumers.py . build/static build/shared
}

clang() {
  configure clang "${unity[@]}" "${bare[@]}"
  compile clang weft_cli tests/determinism/all
  forget_dead_teams
  run_tests clang -L determinism
  same_bits clang
}

debug() {
  configure debug "${unity[@]}" "${bare[@]}"
  compile debug weft_cli tests/determinism/all
  run_tests debug -R '^(Golden|Hash)[.]'
  same_bits debug
}

asan() {
  configure asan "${unity[@]}" -DWEFT_BUILD_BENCH=OFF
  local pictures=()  # as far as there are packages to draw them with
  [[ ! -e build/asan/tests/render/CTestTestfile.cmake ]] || pictures=(tests/render/all)
  compile asan weft_cli tests/{unit,kernels,api,driver,backend,io,fuzz,stability}/all \
    "${pictures[@]}"
  forget_dead_teams
  run_tests asan -L '^(unit|kernels|api|driver|backend|io|render|fuzz|stability)$' -LE long
}

# The OpenMP runtime is not instrumented; its archer library tells the sanitizer of its barriers.
tsan() {
  configure tsan "${unity[@]}" "${bare[@]}"
  compile tsan race weft_tests_threads tests/determinism/all
  forget_dead_teams
  run_tests tsan -L '^(determinism|race)$' -LE long
}

setup_options=(--all)
wanted=(setup docs release cuda hip packaging clang debug asan tsan)
all=("${wanted[@]}" quick)
case "${1:-}" in
  "") ;;
  --quick) wanted=(setup quick) setup_options=() ;;
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
