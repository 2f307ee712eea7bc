#!/usr/bin/env bash
# Instructions of short runs of some scenes, counted by callgrind, beside those recorded in bench/instructions.txt: times
# differ from run to run by a third, counts by a thousandth. Fails where a scene takes 3 % more than recorded.
#
#   bench/instructions.sh            compares
#   bench/instructions.sh --renew    records: after a change that is worth its instructions, or with another compiler
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

recorded=bench/instructions.txt
program=${CARGO_TARGET_DIR:-target}/release/examples/instructions
most=3 # %

if ! command -v valgrind >/dev/null; then
    echo "no valgrind here: instructions are not counted"
    exit 0
fi
# What counts depend on. Results are the same on all processors; instructions are those that valgrind knows of this one.
features=$(grep -owE 'avx2|fma' /proc/cpuinfo | sort -u | paste -sd ' ')
machine="$(rustc --version), $(uname -m) with ${features:-no vectors}"
if [[ ${1:-} != --renew && $machine != "$(head -n 1 "$recorded" | sed 's/^# //')" ]]; then
    echo "counts are recorded for $(head -n 1 "$recorded" | sed 's/^# //'), and this is $machine: not compared; \`bench/instructions.sh --renew\` records them anew"
    exit 0
fi

cargo build --locked --release --example instructions
# One thread: work is not shared out differently.
export RAYON_NUM_THREADS=1
count() { # scene
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" 2>&1 >/dev/null \
        | sed -n 's/.*refs: *//p' | tr -d ,
}

failed=0
found="# $machine"$'\n'
for scene in $("$program"); do
    now=$(count "$scene") || { echo "error: $scene did not come to its end under valgrind" && exit 1; }
    found+="$scene $now"$'\n'
    before=$(sed -n "s/^$scene //p" "$recorded" 2>/dev/null || true)
    if [[ -z $now ]]; then
        echo "error: $scene did not run under valgrind"
        failed=1
    elif [[ -n $before ]]; then
        awk -v scene="$scene" -v now="$now" -v before="$before" \
            'BEGIN { printf "%-20s %12d, recorded %12d: %+.1f %%\n", scene, now, before, 100 * (now / before - 1) }'
        if ((100 * now > (100 + most) * before)); then failed=1; fi
    elif [[ ${1:-} != --renew ]]; then
        echo "error: $scene is not recorded"
        failed=1
    fi
done
if [[ ${1:-} == --renew ]]; then
    printf '%s' "$found" >"$recorded"
elif ((failed)); then
    echo "error: more instructions than recorded, by more than $most %: find out why; where they are worth it, \`bench/instructions.sh --renew\`"
    exit 1
fi
