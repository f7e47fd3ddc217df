#!/bin/bash
# Tests restarts: a run that was stopped, killed, or ended by a full disk continues from its last complete checkpoint, on any
# number of ranks, and ends with the same bits as an uninterrupted run.
source "$(dirname "$0")/harness.sh"

layout() { # FLAG...
  beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic --period 100 \
    --amplitude 0.02 "$@"
}
small() { # RANKS ARGUMENT...
  mpirun -n "$1" beadswim-run "${@:2}" --progress none --no-provenance
}
# Checks that record and trajectory of a run are equal to NAME.json and NAME.h5md, the files of the uninterrupted run.
same_as() { # NAME RECORD TRAJECTORY
  check "the record is that of an unbroken run" cmp -s "$1.json" "$2"
  check "state_sha256 is there" grep -q '"state_sha256": "[0-9a-f]\{64\}"' "$2"
  check "all datasets are those of an unbroken run" h5diff "$1.h5md" "$3"
}
resolution="--cells-per-radius 2 --relaxation-time 1.5"

layout >layout.json
small 1 layout.json -o whole.h5md $resolution --cycles 3 >whole.json

# --- two checkpoints in turn, which change nothing, and from which a run goes on: on other numbers of ranks, to more
# cycles, under another name
run small 2 layout.json -o kept.h5md $resolution --cycles 2.5 --checkpoint-every 0.7
has_status 0
check "two checkpoints" test -s kept.h5md.ckpt.0 -a -s kept.h5md.ckpt.1
check "no others" test "$(ls kept.h5md.ckpt.* | wc -l)" -eq 2
cp kept.h5md first.h5md
for ranks_and_slot in '1 0' '2 1'; do # at 2.1 and 2.5 cycles, in either order
  read -r ranks slot <<<"$ranks_and_slot"
  run small $ranks --restart kept.h5md.ckpt.$slot -o gone.h5md --cycles 3
  has_status 0
  cp out gone.json
  same_as whole gone.json gone.h5md
done
check "the trajectory that a checkpoint belongs to stays until the run ends" cmp -s first.h5md kept.h5md
refuses '^beadswim-run: --tolerance: .* a restart continues with its model and settings; leave the flag out' \
  beadswim-run --restart kept.h5md --cycles 3 --tolerance 0.1
run beadswim-run layout.json --plan --tolerance 5
check "a smaller box is proposed" holds '.proposals | length == 1' out
run beadswim-run --restart kept.h5md --plan --tolerance 5 --cycles 3
has_status 0
check "a restart changes neither scene nor settings" holds '(.runs | length == 1) and .proposals == [] and (.runs[0].flags | test("single") | not)' out
run beadswim-run --restart kept.h5md --plan --cycles 1
has_status 2
err_has '^beadswim-run: --plan: no model can run .* --cycles: .*the checkpoint is already at cycle 2\.5; give more cycles'
run small 2 --restart kept.h5md --cycles 3
has_status 0
cp out gone.json
same_as whole gone.json kept.h5md

# --- the record is lost at the end of a run: what the message says gives it, and with it the trajectory
finishes() { # NAME FLAG...   of the unbroken run; of the run whose record is lost
  run bash -c 'beadswim-run "$@" -o end.h5md --checkpoint-every 0.5 --progress none >/dev/full' finishes "${@:2}"
  has_status 3
  err_has 'continue with --restart end.h5md.ckpt.[01]$'
  rm -f end.h5md
  run small 1 $(sed -n 's/.*: the state is saved; continue with //p' err)
  has_status 0
  cp out end.json
  same_as "$1" end.json end.h5md
  run small 1 --restart end.h5md.ckpt.1 -o again.h5md # once more, under another name
  has_status 0
  check "the record is the same" cmp -s end.json out
}
for flags in "$resolution" "$resolution --refine 1" "--model rpy" "--model unsteady"; do
  small 1 layout.json -o once.h5md $flags --cycles 1 >once.json
  finishes once layout.json $flags --cycles 1
done
run bash -c "beadswim-layout vary layout.json --over phase=1,2 |
  beadswim-run --model rpy -o end-{}.h5md --cycles 1 --checkpoint-every 0.5 --progress none >/dev/full"
has_status 3
check "a stream is told of --restart" test "$(grep -c -- --restart err)" -eq 0

# --- links and saturated cells, both precisions, swarms with periods of their own, flow fields
beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,1 --radius 2 --arm 8 --core-gap 12 \
  --block-gap 8,16,16 --period 100 --amplitude 0.1 --frame initial-axis |
  beadswim-layout defect frequency --sigma 0.2 --seed 2 | beadswim-layout defect rotation --sigma 0.3 --seed 5 >swarm.json
for flags in "--bead-boundary psm" "--bead-boundary cli --precision single --frames-per-cycle 7"; do
  run small 2 swarm.json -o a.h5md --cells-per-radius 2 --cycles 2 --flow-every 1 $flags
  has_status 0
  mv out a.json
  run small 1 swarm.json -o b.h5md --cells-per-radius 2 --cycles 1.31 --flow-every 1 --checkpoint-every 1.31 $flags
  has_status 0
  again=(b.h5md)
  [[ $flags == *cli* ]] && again=(./b.h5md -o b.h5md) # the same file by another name
  run small 2 --restart "${again[@]}" --cycles 2
  has_status 0
  mv out b.json
  same_as a b.json b.h5md
  check "flow fields too" diff -rq a.h5md.flow b.h5md.flow
  check "and their list" test "$(sed s/a.h5md/b.h5md/ a.h5md.flow.pvd)" = "$(cat b.h5md.flow.pvd)"
done

# --- another interval of flow fields: the list has those of all parts of the run, and of no older run
listed() { # NUMBER
  check "not $1 fields are listed" test "$(grep -c '<DataSet' flow.h5md.flow.pvd)" -eq "$1"
  for field in $(grep -o '[0-9]*\.vti' flow.h5md.flow.pvd); do check "$field is missing" test -s flow.h5md.flow/$field; done
}
run small 1 layout.json -o flow.h5md $resolution --cycles 1 --flow-every 0.5 --checkpoint-every 1
listed 2
run small 2 --restart flow.h5md --cycles 1.5 --flow-every 0.25
listed 4
run small 1 --restart flow.h5md --cycles 2.5 --flow-every 1
listed 5
check "times increase" bash -c 'sed -n "s/.*timestep=\"\([^\"]*\).*/\1/p" flow.h5md.flow.pvd | sort -gc'
run small 1 layout.json -o flow.h5md $resolution --cycles 1 --flow-every 1 --checkpoint-every 1
run small 1 --restart flow.h5md --cycles 2
listed 2

# --- a damaged checkpoint is told from a whole one
for slot in 0 1; do cp kept.h5md.ckpt.$slot hurt.h5md.ckpt.$slot; done
newest=$(ls -t kept.h5md.ckpt.? | head -1)
newest_whole=$newest
newest=hurt.h5md.ckpt.${newest: -1}
size=$(stat -c %s "$newest")
printf '\x55' | dd of="$newest" bs=1 seek=$((size / 2)) conv=notrunc status=none
run small 2 --restart "$newest" --cycles 4
has_status 2
err_has 'is damaged: its contents do not match the stored hash'
run small 2 --restart hurt.h5md --cycles 3
has_status 0
err_has "$newest: the checkpoint is damaged.*continuing from the checkpoint hurt.h5md.ckpt.[01]"
cp out hurt.json
same_as whole hurt.json hurt.h5md
head -c 5000 kept.h5md.ckpt.0 >cut.h5md.ckpt.0
run small 2 --restart cut.h5md.ckpt.0 --cycles 4
has_status 2

# --- refusals
refuses "--bead-boundary: the value psm differs from mr, the value in the run of the checkpoint; leave it out" \
  beadswim-run --restart kept.h5md --cycles 9 --bead-boundary psm
refuses '--cells-per-radius: the value 4 differs from 2, ' beadswim-run --restart kept.h5md --cycles 9 --cells-per-radius 4
refuses '--precision: the value single differs from double, ' beadswim-run --restart kept.h5md --cycles 9 --precision single
jq '.fluid.density = 1.01' layout.json >other.json
refuses 'other.json: this layout is not the layout of the checkpoint' beadswim-run other.json --restart kept.h5md --cycles 9
refuses '--cycles: the number of cycles, 1, is too small, because the checkpoint is already at cycle' beadswim-run --restart kept.h5md.ckpt.0 --cycles 1
h5copy -i whole.h5md -o foreign.h5md -s /h5md -d /h5md
cp foreign.h5md foreign.h5md.ckpt.0
refuses 'foreign.h5md.ckpt.0: the file is an HDF5 file but not a checkpoint of Beadswim; name FILE.h5md.ckpt.0, FILE.h5md.ckpt.1' \
  beadswim-run --restart foreign.h5md.ckpt.0
rm foreign.h5md.ckpt.0
refuses 'foreign.h5md has no checkpoint to continue from: neither foreign.h5md.ckpt.0 nor foreign.h5md.ckpt.1 exists and is valid' beadswim-run --restart foreign.h5md
refuses '--restart: nothing.h5md has no checkpoint to continue from: .*; write checkpoints with --checkpoint-every' \
  beadswim-run --restart nothing.h5md
refuses 'nothing.h5md.ckpt.1 does not exist' beadswim-run --restart nothing.h5md.ckpt.1
cp layout.json fake.h5md.ckpt.0
refuses 'fake.h5md.ckpt.0: the file is not a checkpoint' beadswim-run --restart fake.h5md.ckpt.0
cp whole.h5md fake.h5md.ckpt.1
refuses 'fake.h5md.ckpt.1: the file is an HDF5 file but not a checkpoint of Beadswim' beadswim-run --restart fake.h5md.ckpt.1
refuses '--output: the flag is missing; name the trajectory' beadswim-run layout.json
refuses '--checkpoint-every' beadswim-run layout.json -o x.h5md --checkpoint-every 0
accepts bash -c 'beadswim-run layout.json --restart kept.h5md -o same.h5md --cycles 3.1 --cells-per-radius 2.0 --progress none'

# --- other spellings of a name are the same file: what a run goes on from stays until the next is whole
cp "$newest_whole" spelt.h5md.ckpt.1
run small 1 --restart ./spelt.h5md.ckpt.1 -o spelt.h5md --cycles 3.2 --checkpoint-every 1e20
has_status 0
check "the first checkpoint goes into the other slot, and there is one for the end alone" \
  test -s spelt.h5md.ckpt.0 -a -s spelt.h5md.ckpt.1 -a ! -e spelt.h5md.ckpt.1.old
check "what it went on from is as it was" cmp -s "$newest_whole" spelt.h5md.ckpt.1

# --- a new run puts an older run's checkpoints aside, which a restart would take for its own
cp kept.h5md.ckpt.1 older
run small 1 layout.json -o kept.h5md $resolution --cycles 0.2
has_status 0
check "none are left, and nothing is lost" test ! -e kept.h5md.ckpt.0 -a ! -e kept.h5md.ckpt.1
check "the older one is there" cmp -s older kept.h5md.ckpt.1.old

rest_is_long

# --- stopped on purpose: a checkpoint without having asked for any, exit status 4
small 2 layout.json -o long.h5md $resolution --cycles 40 >long.json
run beadswim-run layout.json -o timed.h5md $resolution --cycles 40 --time-limit 0.3 --progress none --no-provenance
has_status 4
err_has 'the state is saved; continue with --restart timed.h5md.ckpt.0'
check "an index for ParaView is there on early stops too" test -s timed.h5md.xdmf2
for _ in $(seq 200); do
  run small 2 --restart timed.h5md --time-limit 0.8
  [ $status -eq 4 ] || break
done
has_status 0
cp out timed.json
same_as long timed.json timed.h5md

name=told$$.h5md
for signal in TERM USR1; do
  rm -f told*.h5md*
  mpirun -n 2 beadswim-run layout.json -o $name $resolution --cycles 1e5 --progress none >out 2>err &
  for _ in $(seq 100); do [ -s $name.part ] && break; sleep 0.1; done
  sleep 0.5
  kill -$signal "$(pgrep -f "^beadswim-run .*$name" | head -1)"  # one rank, as srun and batch systems do
  status=0
  wait $! || status=$?
  command_line="kill -$signal (one rank of a running beadswim-run)"
  has_status 4
  check "status" test "$(jq -r .status out)" = stopped-signal
  check "a checkpoint" test -s $name.ckpt.0
done
# Open MPI hands SIGUSR1 on.
rm -f told.h5md*
mpirun -n 2 beadswim-run layout.json -o told.h5md $resolution --cycles 1e5 --progress none >out 2>err &
for _ in $(seq 100); do [ -s told.h5md.part ] && break; sleep 0.1; done
sleep 0.5
kill -USR1 $!
status=0
wait $! || status=$?
command_line="kill -USR1 mpirun"
has_status 4
check "a checkpoint" test -s told.h5md.ckpt.0
# mpirun itself gives ranks a second after SIGTERM; whatever they came to, the run goes on from.
rm -f told.h5md*
mpirun -n 2 beadswim-run layout.json -o told.h5md $resolution --cycles 40 --checkpoint-every 1 --progress none >out 2>err &
for _ in $(seq 100); do [ -s told.h5md.ckpt.1 ] && break; sleep 0.05; done
kill -TERM $!
wait $!
run small 2 --restart told.h5md
has_status 0
cp out told.json
same_as long told.json told.h5md

# --- killed at random moments, most of them while a checkpoint is written
RANDOM=7
small 1 layout.json -o killed.h5md $resolution --cycles 60 >never.json 2>/dev/null
cp never.json unbroken.json
mv killed.h5md unbroken.h5md
kills=0
command_line="kill -KILL (a running beadswim-run)"
for attempt in $(seq 60); do
  from=(layout.json $resolution --cycles 60)
  ls killed.h5md.ckpt.? >/dev/null 2>&1 && from=(--restart killed.h5md)
  beadswim-run "${from[@]}" -o killed.h5md --checkpoint-every 0.05 --progress none --no-provenance >out 2>err &
  pid=$!
  sleep "0.$((RANDOM % 900 + 100))"
  if [ $attempt -le 4 ] && kill -KILL $pid 2>/dev/null; then
    wait $pid 2>/dev/null
    kills=$((kills + 1))
    continue
  fi
  status=0
  wait $pid || status=$?
  break
done
has_status 0
check "it was killed more than once" test $kills -gt 1
cp out killed.json
same_as unbroken killed.json killed.h5md

# --- a full disk: what is kept stays, and the run goes on when there is room
cat >full.sh <<'FULL'
mkdir full && mount -t tmpfs -o size=3m none full || exit 77
cd full
timeout 60 mpirun -n "$1" beadswim-run ../layout.json -o full.h5md --cells-per-radius 2 --relaxation-time 1.5 --cycles 3 \
  --checkpoint-every 0.2 --progress none >../full.out 2>../full.err
echo $? >../full.status
cp full.h5md.ckpt.? ..
FULL
for ranks in 1 2; do
  rm -rf full full.h5md* full.status
  if unshare -m true 2>/dev/null; then unshare -m bash full.sh $ranks; else break; fi
  [ -e full.status ] || break
  command_line="beadswim-run on a full disk, $ranks ranks"
  status=$(<full.status)
  cp full.err err
  has_status 3
  err_has 'is the disk full'
  run small 2 --restart full.h5md
  has_status 0
  cp out full.json
  same_as whole full.json full.h5md
  cat >again.sh <<'AGAIN'
mount -t tmpfs -o size=20k none full || exit 77
timeout 60 mpirun -n "$1" beadswim-run --restart full.h5md.ckpt.0 -o full/again.h5md --cycles 9 --progress none >full.out 2>full.err
echo $? >full.status
AGAIN
  mkdir -p full
  unshare -m bash again.sh $ranks
  command_line="beadswim-run --restart on a full disk, $ranks ranks"
  status=$(<full.status)
  cp full.err err
  has_status 3
  err_has 'cannot be copied to a file: No space left'
done

finish
