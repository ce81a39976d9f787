#!/usr/bin/env bash
# Builds the documents as a site in out/docs/site; fails on a page or link that is missing.
# usage: scripts/docs.sh
# Needs mkdocs: scripts/setup.sh --all installs it.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v mkdocs >/dev/null; then
  echo "docs: mkdocs is missing (it builds the site) run scripts/setup.sh --all" >&2
  exit 1
fi
python3 -B tests/hygiene/links.py .
rm -rf out/docs
python3 -B scripts/docs_pages.py . out/docs/pages
mkdocs build --strict --quiet
echo "docs: out/docs/site/index.html"
