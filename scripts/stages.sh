# shellcheck shell=bash
# Stages of a script: each under a heading, timed, its failure remembered; and what scripts ask of a
# machine. For `source`.

have_nvcc() { command -v nvcc >/dev/null || [[ -x "${CUDA_HOME:-/usr/local/cuda}/bin/nvcc" ]]; }

# What the environment names, the device's own architecture, or 80.
cuda_architecture() {
  local capability
  capability=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null |
    head -n 1 || true)
  capability=${capability//./}
  [[ "$capability" =~ ^[0-9]+$ ]] || capability=80
  echo "${CUDA_ARCHITECTURES:-$capability}"
}

stage_lines=()
stage_failed=0
stage_logs=$(mktemp -d)
summaries=$stage_logs/summaries
: >"$summaries"
trap 'rm -rf "$stage_logs"' EXIT

stage() {  # NAME COMMAND...
  local name=$1 began=$SECONDS status seconds outcome=passed log=$stage_logs/$1.log
  printf '\n==== %s ====\n' "$name"
  set +e
  (set -e; "${@:2}") 2>&1 | tee "$log"
  status=${PIPESTATUS[0]}
  set -e
  seconds=$((SECONDS - began))
  if [[ $status -ne 0 ]]; then
    outcome="FAILED (exit code $status)"
    stage_failed=1
    keep_last_lines "$name" "$log"
  fi
  rm -f "$log"
  printf -- '---- %s: %s, %d s\n' "$name" "$outcome" "$seconds"
  stage_lines+=("$(printf '%-10s %5d s  %s' "$name" "$seconds" "$outcome")")
}

stage_if() {  # CONDITION WHY_NOT NAME COMMAND...
  if $1; then
    stage "${@:3}"
  else
    stage_lines+=("$(printf '%-10s %5s    skipped: %s' "$3" - "$2")")
  fi
}

keep_summary() {  # NAME CTEST_LOG: for the end
  {
    printf '%s:\n' "$1"
    grep -E 'tests passed|tests failed|Total Test time|^\s+[0-9]+ - |No tests' "$2" | sed 's/^/  /'
  } >>"$summaries" || true
}

keep_last_lines() {  # NAME LOG: a log's end is what people see first, and often all they see
  {
    printf '%s, its last lines:\n' "$1"
    tail -n 40 "$2" | sed 's/^/  /'
  } >>"$summaries"
}

finish() {
  printf '\n==== summary ====\n'
  printf '%s\n' "${stage_lines[@]}"
  cat "$summaries"
  exit "$stage_failed"
}
