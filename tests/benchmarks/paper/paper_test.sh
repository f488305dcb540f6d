#!/usr/bin/env bash
# paper_test.sh BUILD SCRATCH: samples/paper.sh --quick makes everything, makes only again what is missing, and
# refuses what it cannot do.
set -euo pipefail
paper=$(dirname "${BASH_SOURCE[0]}")/../../../samples/paper.sh
build=$1
results=$2/results

remade() {
  local said
  said=$("$paper" --quick --build "$build" --to "$results") || said+=$'\n'"== ended with $?"
  grep '^== ' <<<"$said" || true
}
expect() {
  [[ $2 == "$3" ]] || { printf '%s:\n%s\ninstead of\n%s\n' "$1" "$2" "$3" >&2; exit 1; }
}
refused() {
  local status=0
  "$paper" "$@" 2>/dev/null || status=$?
  expect "exit code of paper.sh $*" "$status" 2
}

rm -rf "$results"
expect "ribbons tied and drawn, counts of box tests" "$(remade | wc -l)" 39
expect "rows with the methods" "$(grep --count -e '| gate |' -e '| as published |' "$results/tables.md")" 24
expect "contact sheets in the table" "$(grep --count '](paper/' "$results/tables.md")" 14
expect "rows of box tests" "$(grep --count '| 4x300 |' "$results/tables.md")" 2
expect "curves of box tests" "$(grep --count '<polyline' "$results/box-tests.svg")" 10
expect "contact sheets for documents" "$(find "$results" -name '*.small.png' | wc -l)" 14

expect "what is made again when all is there" "$(remade)" ""
rm "$results/18-fine-gate.verify"
expect "what is made again of a run that was stopped" "$(remade)" "== Tying 18-fine, gate"

# A run by the gate that is not what was promised.
sed -i 's/"passed": true/"passed": false/' "$results/18-fine-gate.verify"
status=0
wrong=$("$paper" --quick --build "$build" --to "$results" | grep '^WRONG') || status=$?
expect "exit code when the gate breaks its promise" "$status" 1
expect "what breaks it" "$wrong" "WRONG: 18-fine"

refused --build "$build" --to "$results"
refused --quick --docs
refused --quickly
refused --to
