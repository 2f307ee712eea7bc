#!/usr/bin/env bash
# Hands out the points of a plan as a Slurm array, each task a share of them, and collects them at the end.
#
#   tools/sweep_slurm.sh PROGRAM plan.toml FOLDER [TASKS] [options of sbatch ..]
#
# The program and the folder must be seen by all nodes. A point that is there is not computed again: after a task was
# killed, or a node lost, the same command does what is missing.
set -euo pipefail

if [[ $# -lt 3 ]]; then
    sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
program=$(realpath "$1") plan=$(realpath "$2") out=$(realpath -m "$3")
points=$(sed -n 's/^points = \([0-9]*\)$/\1/p' "$plan")
[[ -n $points ]] || { echo "error: $plan has no line \`points = ..\`; write it with \`$1 plan\`" >&2; exit 2; }
tasks=${4:-100}
shift $(($# < 4 ? $# : 4))
tasks=$((tasks < points ? tasks : points))
mkdir -p "$out"

# Arrays are limited in length; each task takes every so-manieth point.
array=$(sbatch --parsable --array="0-$((tasks - 1))" --job-name=sweep --output="$out/slurm-%A_%a.log" "$@" <<END
#!/usr/bin/env bash
for ((index = SLURM_ARRAY_TASK_ID; index < $points; index += $tasks)); do
    "$program" task --plan "$plan" --index "\$index" --out "$out"
done
END
)
collect=$(sbatch --parsable --dependency="afterany:$array" --job-name=collect --output="$out/slurm-collect.log" "$@" <<END
#!/usr/bin/env bash
"$program" collect --plan "$plan" --out "$out"
END
)
echo "array $array of $tasks tasks for $points points, then $collect collects them in $out"
