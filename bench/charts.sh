#!/usr/bin/env bash
# Work-precision charts of the paper's scenes, into docs/charts: CSV and SVG of each. What is there already is kept: an
# interrupted call goes on where it was, and names of charts behind it make these alone.
#
#   bench/charts.sh [name ...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

work=${CHARTS_WORK:-target/charts}
target=${CARGO_TARGET_DIR:-target}
# One thread: cost is that of one core.
export RAYON_NUM_THREADS=1

chart() { # name, example, arguments
    local name=$1 example=$2
    shift 2
    if [[ ${#chosen[@]} -gt 0 && " ${chosen[*]} " != *" $name "* ]]; then return; fi
    printf '\n== %s\n' "$name"
    if [[ $is_built != *" $example "* ]]; then
        cargo build --locked --release --example "$example"
        is_built+=" $example "
    fi
    "$target/release/examples/$example" chart "$@" --out "$work/$name"
    mkdir -p docs/charts
    cp "$work/$name/chart.csv" "docs/charts/$name.csv"
    cp "$work/$name/chart_time.svg" "docs/charts/$name.svg"
    cp "$work/$name/chart_work.svg" "docs/charts/${name}_work.svg"
}

chosen=("$@")
is_built=""
wanted=(--wanted 1e-2,1e-3,1e-4,1e-5,1e-6,1e-7)
short=(--rtols 1e-3..1e-8 "${wanted[@]}")

chart spin_up_4 spin_up elements=4,8,16 omega_s="4 rad/s" --limit "10 s" "${wanted[@]}"
chart spin_up_10 spin_up elements=8,16 omega_s="10 rad/s" --limit "5 s" "${wanted[@]}"
chart spin_up_40 spin_up elements=16,24 omega_s="40 rad/s" --limit "5 s" "${short[@]}"
chart spin_up_100 spin_up elements=48 omega_s="100 rad/s" --limit "10 s" "${short[@]}"
for way in upwind downwind out_of_plane; do
    chart "curved_$way" curved_beam --model "$way" elements=4,8 --limit "10 s" "${short[@]}"
done
chart motor motor T_s="0.1 s" --t-end "0.12 s" --every "0.5 ms" --outputs v_mid --limit "10 s" --rtols 1e-4..1e-10 "${wanted[@]}"
chart slider_crank slider_crank elements=4,8 --limit "10 s" "${wanted[@]}"
chart free_flight free_flight elements=3,6 --limit "10 s" "${short[@]}"
chart esail esail tethers=20 elements=4,8 --formulations rncf --outputs z_tip_max,spin,tension_main --limit "10 s" --rtols 1e-3..1e-7 "${wanted[@]}"
chart pinned_pipe pinned_pipe elements=8,16 --outputs v --limit "10 s" "${wanted[@]}"
