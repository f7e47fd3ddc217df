#!/bin/bash
# Tests the job scripts of examples/slurm, with scripts in place of srun and scontrol: a job that Slurm tells to stop queues
# itself again, and the run ends with the same bits as an uninterrupted run.
source "$(dirname "$0")/harness.sh"
jobs=$BEADSWIM_SOURCE/examples/slurm

mkdir bin
cat >bin/srun <<'SRUN'
#!/bin/bash
# Slurm signals the ranks themselves; as soon as there is a checkpoint or a trajectory under way, if asked to.
exec 3>&1
mpirun -n 2 "$@" &
if [ -n "${STOP_EARLY-}" ]; then
  until [ -e slurm.h5md.ckpt.0 ] || ! kill -0 $!; do sleep 0.1; done
  kill -USR1 "$(pgrep -f "^beadswim-run .*slurm.h5md" | tail -1)"
fi
if [ -n "${TIME_IS_UP-}" ]; then
  until [ -e part-1/run-1.h5md.part ] || ! kill -0 $!; do sleep 0.05; done
  pkill -USR1 -f "^beadswim-run .*part-1/"
fi
wait $!
SRUN
printf '#!/bin/bash\necho "$@" >>requeued\n' >bin/scontrol
chmod +x bin/*
export PATH=$PWD/bin:$PATH SLURM_JOB_ID=17

beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic --period 100 \
  --amplitude 0.02 >layout.json
flags=(--cells-per-radius 2 --relaxation-time 1.5 --cycles 60 --no-provenance)
beadswim-run layout.json -o whole.h5md "${flags[@]}" --progress none >whole.json
STOP_EARLY=yes run bash "$jobs/run.sbatch" layout.json slurm.h5md "${flags[@]}"
has_status 4
check "it is queued again" grep -q '^requeue 17$' requeued
check "no record yet" test ! -e slurm.json
run bash "$jobs/run.sbatch" layout.json slurm.h5md "${flags[@]}"
has_status 0
check "queued once" test "$(wc -l <requeued)" -eq 1
check "trajectory of an unbroken run" h5diff whole.h5md slurm.h5md
state() { jq -r .state_sha256 "$1"; }
check "state of an unbroken run" test "$(state whole.json)" = "$(state slurm.json)"
rm slurm.json slurm.h5md
run bash "$jobs/run.sbatch" layout.json slurm.h5md "${flags[@]}"
has_status 0
check "a job after the end finishes the run again" test "$(state whole.json)" = "$(state slurm.json)" -a -s slurm.h5md

# --- a study in two jobs of an array
rm requeued
beadswim-layout vary layout.json --over phase=30deg,60deg,90deg,120deg,150deg >study.jsonl
flags=(--cells-per-radius 2 --relaxation-time 1.5 --cycles 60 --no-provenance)
beadswim-run study.jsonl "${flags[@]}" -o whole-{}.h5md --progress none >whole.jsonl
export SLURM_ARRAY_JOB_ID=17 SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_MIN=1
job() { SLURM_ARRAY_TASK_ID=$1 run bash "$jobs/study.sbatch" study.jsonl study "${flags[@]}"; }
TIME_IS_UP=yes job 1
has_status 4
check "the job is queued again" grep -q '^requeue 17_1$' study/requeued
check "it has no records yet" test ! -e study/part-1.jsonl
check "checkpoints of what was under way" test -e study/part-1/run-1.h5md.ckpt.0
job 1
has_status 0
check "they were continued" test ! -e study/part-1/run-1.h5md.ckpt.0.old
job 2
has_status 0
results() { jq -c 'del(.request_sha256)' "$@" | sort; }
check "records of an unbroken run" cmp <(results study/part-*.jsonl) <(results whole.jsonl)
cp study/part-1.jsonl first.jsonl
job 1
has_status 0
check "what is done is left alone" cmp -s first.jsonl study/part-1.jsonl
for script in "$jobs"/*.sbatch; do check "$script parses" bash -n "$script"; done
finish
