#!/usr/bin/env bash
# Measures what self-collision finds and costs, and writes docs/self-collision.md with its plots.
# usage: scripts/self_collision.sh [--quick]
# Takes five minutes on a machine that does nothing else, half a minute with --quick.
exec "$(dirname "$0")/bench_page.sh" collide self_collision self-collision "$@"
