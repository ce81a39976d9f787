#!/usr/bin/env bash
# Measures what keeps cloth from stretching costs, and writes docs/solvers.md with its plots.
# usage: scripts/solvers.sh [--quick]
# Takes two minutes on a machine that does nothing else, seconds with --quick.
exec "$(dirname "$0")/bench_page.sh" stretch solvers solvers "$@"
