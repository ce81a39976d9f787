#!/usr/bin/env bash
# Checks weft on a machine with an NVIDIA GPU, and writes one report.
# usage: scripts/gpu_check.sh [--again] [--build DIR] [--results DIR] [STAGE...]
#   --again        also the stages that passed before; without it a second call goes on
#   --build DIR    where it builds (default: build/gpu)
#   --results DIR  where logs, figures and report.md go (default: out/gpu_check)
#   STAGE          only these of: prepare build tests parity sanitize bench report
#
# The machine with the GPU needs no package registry: run `scripts/gpu_check.sh prepare` where there
# is one, and take the whole folder along. Third-party headers and libraries are then found in
# build/gpu_packages (below 60 MiB). Every stage ends within 8 minutes, for a machine with a GPU is
# often lent. Without a GPU only prepare and build run, as long as they take.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/stages.sh

packages=$PWD/build/gpu_packages
results=$PWD/out/gpu_check
build=$PWD/build/gpu
jobs=${JOBS:-$(nproc)}
stage_seconds=480
again=false
all=(prepare build tests parity sanitize bench report)
wanted=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --again) again=true ;;
    --results | --build)
      [[ $# -gt 1 ]] || { echo "gpu_check: $1 needs a folder" >&2; exit 2; }
      if [[ $1 == --build ]]; then build=$(realpath -m "$2"); else results=$(realpath -m "$2"); fi
      shift
      ;;
    *)
      if [[ " ${all[*]} " != *" $1 "* ]]; then
        echo "gpu_check: $1 is not a stage; give some of ${all[*]}" >&2
        exit 2
      fi
      wanted+=("$1")
      ;;
  esac
  shift
done
[[ ${#wanted[@]} -gt 0 ]] || wanted=("${all[@]}")
mkdir -p "$results"
weft=$build/tools/weft

is_unprepared() { [[ $again == true || ! -d "$packages" ]]; }
have_gpu() { nvidia-smi -L >/dev/null 2>&1; }

# Copies what distribution packages installed, below one prefix.
prepare() {
  scripts/setup.sh
  rm -rf "$packages"
  mkdir -p "$packages"
  local package file
  for package in libgtest-dev libgmock-dev libeigen3-dev nlohmann-json3-dev libcli11-dev; do
    dpkg-query -W "$package" >/dev/null 2>&1 || continue
    while read -r file; do
      case $file in
        /usr/include/* | /usr/lib/* | /usr/share/cmake/* | /usr/share/eigen3/*)
          [[ -f "$file" ]] && cp --parents -L "$file" "$packages" ;;
      esac
    done < <(dpkg-query -L "$package")
  done
  # Meshes that the sample scenes read.
  while read -r file; do
    [[ -f "$file" ]] && cp --parents -L "$file" "$packages"
  done < <(grep -oh '"/usr/share/[^"]*"' samples/scenes/*.json | tr -d '"' | sort -u)
  local mib
  mib=$(du -sm "$packages" | cut -f1)
  echo "build/gpu_packages: $mib MiB"
  if [[ $mib -ge 60 ]]; then
    echo "build/gpu_packages must stay below 60 MiB" >&2
    return 1
  fi
}

build() {
  local options=(-B "$build" -DCMAKE_CUDA_ARCHITECTURES="$(cuda_architecture)"
                 -DWEFT_WARNINGS_AS_ERRORS="${WARNINGS_AS_ERRORS:-OFF}")
  [[ ! -d "$packages" ]] || options+=(-DCMAKE_PREFIX_PATH="$packages/usr")
  command -v ninja >/dev/null || options+=(-G "Unix Makefiles")
  if have_nvcc && command -v nvcc >/dev/null; then
    CUDA_HOME=${CUDA_HOME:-$(dirname "$(dirname "$(readlink -f "$(command -v nvcc)")")")}
    export CUDA_HOME
  fi
  cmake --preset cuda "${options[@]}"
  # shellcheck disable=SC2046
  cmake --build "$build" --parallel "$jobs" --target weft_cli $(test_targets)
}

test_folders=(backend kernels api physics stability determinism)
test_targets() { printf 'tests/%s/all ' "${test_folders[@]}"; }

# Worlds of the tests are made on the GPU, where tiny steps take long; several programs run at once.
# What a limit cuts off is left for the next call.
tests() {
  local programs program groups=${WEFT_GPU_TEST_GROUPS:-8} folder filter round
  programs=$(for folder in "${test_folders[@]}"; do
    find "$build/tests/$folder" -maxdepth 1 -type f -name 'weft_tests_*' -perm -u+x
  done)
  mkdir -p "$results/tests"
  round=$(find "$results/tests" -name '*.log' | wc -l)
  for program in $programs; do
    python3 scripts/gpu_report.py remaining "$results" "$program" "$groups" |
      while read -r filter; do
        echo "$program" "$((++round))" "$filter"
      done
  done | WEFT_TEST_BACKEND=cuda OMP_WAIT_POLICY=passive xargs -P "$jobs" -L 1 bash -c '
      timeout "${WEFT_GPU_TEST_SECONDS:-400}" "$1" --gtest_filter="$3" \
        >"$0/$(basename "$1").$2.log" 2>&1 || true' "$results/tests"
  python3 scripts/gpu_report.py tests "$results"
}

# Every sample scene gives the same bits on the host and on the GPU.
parity() {
  local scene name backend failed=0
  mkdir -p "$results/parity"
  for scene in samples/scenes/*.json; do
    name=$(basename "$scene" .json)
    if [[ -d "$packages/usr/share" && ! -d /usr/share/assimp ]]; then
      sed "s#\"/usr/share/#\"$packages/usr/share/#" "$scene" >"$results/parity/$name.scene.json"
      scene=$results/parity/$name.scene.json
    fi
    for backend in omp cuda; do
      "$weft" run --backend "$backend" --final "$results/parity/$name.$backend.csv" \
        --report "$results/parity/$name.$backend.json" "$scene" >/dev/null || failed=1
    done
  done
  python3 scripts/gpu_report.py parity "$results"
  return "$failed"
}

sanitize() {
  local tool failed=0 log
  mkdir -p "$results/sanitize"
  for tool in memcheck initcheck synccheck racecheck; do
    log=$results/sanitize/$tool.log
    if ! timeout 110 compute-sanitizer --tool "$tool" --error-exitcode 9 \
        "$weft" run --backend cuda \
        --time 0.05 samples/scenes/sheet_on_sphere.json >"$log" 2>&1; then
      failed=1
    fi
    echo "$tool: $(grep -E 'ERROR SUMMARY|RACECHECK SUMMARY' "$log" || tail -n 1 "$log")"
  done
  return "$failed"
}

bench() {
  "$weft" bench gpu --json "${WEFT_GPU_BENCH_OPTIONS[@]}" >"$results/bench.json"
  python3 scripts/gpu_report.py bench "$results"
}
read -r -a WEFT_GPU_BENCH_OPTIONS <<<"${WEFT_GPU_BENCH_OPTIONS:-}"

report() {
  python3 scripts/gpu_report.py report "$results" >"$results/report.md"
  echo "$results/report.md"
}

describe_machine() {
  {
    nvidia-smi --query-gpu=name,driver_version,memory.total,clocks.max.sm --format=csv,noheader |
      head -n 1
    nvcc --version 2>/dev/null | grep release || true
    ${CXX:-g++} --version | head -n 1
    git log -1 --format='%h %s' 2>/dev/null || true
    date -u +%Y-%m-%d
  } >"$results/machine.txt"
}

limited() {  # STAGE: in a shell of its own, so that a limit can end it
  export -f "$1" cuda_architecture test_targets have_nvcc
  local script
  script=$(declare -p packages results build jobs weft test_folders WEFT_GPU_BENCH_OPTIONS)
  local status=0
  timeout --foreground "$stage_seconds" bash -c "set -euo pipefail; $script; $1" || status=$?
  if [[ $status -eq 124 ]]; then
    echo "gpu_check: $1 ran past $stage_seconds s and was ended" >&2
  fi
  [[ $status -eq 0 ]] || return "$status"
  date -u +%FT%TZ >"$results/$1.done"
}

if have_gpu; then
  describe_machine
else
  stage_seconds=0  # no limit
fi
for name in "${wanted[@]}"; do
  [[ $again == false ]] || rm -rf "${results:?}/$name" "$results/$name.done"
  if [[ -e "$results/$name.done" && $again == false && $name != report ]]; then
    stage_lines+=("$(printf '%-10s %5s    passed before (--again repeats it)' "$name" -)")
    continue
  fi
  case $name in
    prepare) stage_if is_unprepared "build/gpu_packages is there" prepare limited prepare ;;
    build) stage_if have_nvcc "nvcc is missing" build limited build ;;
    *) stage_if have_gpu "no NVIDIA GPU here" "$name" limited "$name" ;;
  esac
done
finish
