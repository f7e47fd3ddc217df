#!/bin/bash
# Tests the job scripts of examples/slurm, with scripts in place of srun and scontrol: a job that Slurm tells to stop queues
# itself again, and the run ends with the same bits as an uninterrupted run.
source "$(dirname "$0")/harness.sh"
jobs=$BEADSWIM_SOURCE/examples/slurm

mkdir bin
cat >bin/srun <<'SRUN'
#!/bin/bash
# Slurm signals the ranks themselves; as soon as there is a checkpoint, if asked to.
exec 3>&1
if [ -n "${TIME_IS_UP-}" ]; then exec mpirun -n 2 "$@" --time-limit 1e-9; fi
mpirun -n 2 "$@" &
if [ -n "${STOP_EARLY-}" ]; then
  until [ -e slurm.h5md.ckpt.0 ] || ! kill -0 $!; do sleep 0.1; done
  kill -USR1 "$(pgrep -f "^beadswim-run .*slurm.h5md" | tail -1)"
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

# --- a sweep, one job of its array
rm requeued
export SLURM_JOB_ID=17 SLURM_ARRAY_JOB_ID=17 SLURM_ARRAY_TASK_ID=2000
TIME_IS_UP=yes run bash "$jobs/sweep.sbatch" sweep --model rpy --steps-per-cycle 50
has_status 4
check "the sweep's job is queued again" grep -q '^requeue 17_2000$' sweep/requeued
check "it has no record yet" test ! -e sweep/T2000.json
run bash "$jobs/sweep.sbatch" sweep --model rpy --steps-per-cycle 50
has_status 0
err_has 'continuing from '
check "the sweep's record is there" holds '.status == "finished" and .driving.period == 2000' sweep/T2000.json
accepts beadswim-plot velocity-against-period sweep/T*.json
cp sweep/T2000.json whole.json
run bash "$jobs/sweep.sbatch" sweep --model rpy --steps-per-cycle 50
has_status 0
check "what is done is left alone" cmp -s whole.json sweep/T2000.json
for script in "$jobs"/*.sbatch; do check "$script parses" bash -n "$script"; done
finish
