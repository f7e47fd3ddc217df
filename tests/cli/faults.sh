#!/bin/bash
# Tests faults outside the programs: full disks, closed standard output, folders without permission to write, files that
# disappear, ranks that die. Each program must report the fault, end with the exit status of docs/exit-status.md, and leave
# existing files unchanged. A run that continues after such a fault must give the same bits as an uninterrupted run.
source "$(dirname "$0")/harness.sh"

swimmer() { beadswim-layout swimmer --preset paper-single --box "$1" --boundary periodic "${@:2}"; }
swimmer 60,40,40 --period 2000 --amplitude 0.2 >layout.json
swimmer 32,16,16 --radius 2 --arm 9 --period 100 --amplitude 0.02 >small.json
jq -c . layout.json >layout.jsonl
lbm="small.json --cells-per-radius 2 --relaxation-time 1.5"
rpy="layout.json --model rpy --steps-per-cycle 40"
quietly() { # RANKS ARGUMENT...
  mpirun -n "$1" beadswim-run "${@:2}" --progress none --no-provenance
}
quietly 1 $rpy -o run.h5md --cycles 1 >run.json
beadswim-theory layout.json --method rpy-ode >prediction.json

views=()  # beadswim-view, where Node.js made its page
beadswim-view run.h5md -o page.html 2>/dev/null && views=("view run.h5md -o -")

# Runs a command and checks that it ends with exit status 3 and that its own message on standard error matches REGEX.
fails() { # REGEX COMMAND...
  run "${@:2}"
  has_status 3
  err_has "^beadswim-[a-z]+: .*$1"
}

# --- standard output is full, or closed
programs=('layout swimmer --preset paper-single' 'layout swarm --preset paper-uniform' 'layout check layout.json' \
  'layout reduce layout.json' 'layout defect phase --sigma 0.1 --seed 1 layout.json' 'layout --help' \
  'theory layout.json --method rpy-ode' 'theory --jsonl layout.jsonl --method rpy-ode' \
  'compare run.json prediction.json --tolerance 0.9' 'plot stroke run.json prediction.json -o -' \
  "run $rpy -o full.h5md --cycles 1" 'run --help' 'optimise --help' 'bench --help' "${views[@]}")
for command in "${programs[@]}"; do
  fails 'standard output: the text cannot be written: No space left on device' bash -c "beadswim-$command >/dev/full"
  fails 'standard output: the text cannot be written: Bad file descriptor' bash -c "beadswim-$command >&-"
done
# A file that a program opens, such as the copy of its standard input, must not take the place of standard output.
for command in 'layout check -' 'layout reduce -' 'layout defect phase --sigma 0.1 -' 'layout vary - --over period=1,2' \
  'theory - --method rpy-ode' 'theory --jsonl - --method rpy-ode' 'plot swarm - -o -' "run ${rpy/layout.json/-} -o full.h5md --cycles 1"; do
  fails 'standard output: the text cannot be written: Bad file descriptor' bash -c "beadswim-$command <layout.json >&-"
done
fails 'standard output: the text cannot be written: Bad file descriptor' \
  bash -c 'beadswim-compare - prediction.json --tolerance 0.9 <run.json >&-'
fails 'standard output: the text cannot be written: Bad file descriptor' \
  bash -c "beadswim-run $rpy -o full.h5md --cycles 1 <&- >&-"
run bash -c "beadswim-run $rpy -o full.h5md --cycles 1 --progress none >record <&- 2>&-"
has_status 0
check "the record is whole although the other streams are closed" test "$(jq -r .status record)" = finished
check "the run's trajectory is whole" h5diff run.h5md full.h5md

rest_is_long

# --- inputs that are not there, or cannot be: no folder on the way, a name that is too long
missing="nothing.json layout.json/x $(printf 'x%.0s' $(seq 300)).json"
for file in $missing; do
  for command in "layout check $file" "layout reduce $file" "layout defect phase --sigma 0.1 $file" "theory $file" \
    "theory layout.json --stroke-from $file" "compare $file prediction.json" "compare run.json $file" \
    "plot stroke $file -o figure.svg" "plot trajectories $file -o figure.svg" "run $file -o never.h5md" \
    "${views[@]/run.h5md/$file}"; do
    refuses 'the file cannot be read: (No such file|Not a directory|File name too long)' beadswim-$command
  done
  refuses 'does not exist|has no checkpoint to continue from' beadswim-run --restart "$file.h5md.ckpt.0"
done
check "nothing was written" test ! -e figure.svg -a ! -e never.h5md -a ! -e never.h5md.part

# --- outputs that cannot be created
ln -s loop.svg ring.svg
ln -s ring.svg loop.svg
for folder in nothing layout.json "$(printf 'x%.0s' $(seq 300))"; do
  refuses 'cannot be created: (No such file|Not a directory|File name too long)' \
    beadswim-plot stroke run.json -o "$folder/figure.svg"
  refuses 'cannot be created: (No such file|Not a directory|File name too long)' \
    beadswim-run $rpy --progress none -o "$folder/run.h5md"
done
refuses 'loop.svg: the file cannot be created: Too many levels of symbolic links' beadswim-plot stroke run.json -o loop.svg
refuses 'cannot be created: Too many levels of symbolic links' beadswim-run $rpy --progress none -o loop.svg

# --- a disk that is full or read-only, where this machine lets us mount one
disk() { # SIZE SHELL-COMMANDS: in an empty folder on a disk of so many kilobytes, with what they print in ../disk.out
  rm -rf disk
  mkdir disk
  run unshare -m bash -c "mount -t tmpfs -o size=${1}k none disk && cd disk && $2"
}
if unshare -m bash -c 'mkdir -p disk && mount -t tmpfs none disk' 2>/dev/null; then
  for kind in svg png; do
    disk 4 "echo older >a.$kind; beadswim-plot trajectories ../run.h5md -o a.$kind; echo \$? >../status; ls; cat a.$kind"
    check "plot: status 3" test "$(<status)" = 3
    err_has "beadswim-plot: a.$kind: the file cannot be written: No space left"
    out_is "a.$kind
older"
    disk 99 "echo older >a.$kind; mount -o remount,ro \"\$PWD\"; beadswim-plot stroke ../run.json -o a.$kind; echo \$? >../status; cat a.$kind"
    check "plot: status 2" test "$(<status)" = 2
    err_has 'cannot be created: Read-only file system'
    out_is older
  done
  for run in "$rpy" "$lbm"; do
    disk 100 "echo older >a.h5md; cd ..; beadswim-run $run -o disk/a.h5md --progress none; echo \$? >status; cat disk/a.h5md"
    check "run: status 3" test "$(<status)" = 3
    err_has 'beadswim-run: disk/a.h5md.part: .*is the disk full'
    out_is older
    disk 99 "echo older >a.h5md; mount -o remount,ro \"\$PWD\"; cd ..; beadswim-run $run -o disk/a.h5md; echo \$? >status; cat disk/a.h5md"
    check "run: status 2" test "$(<status)" = 2
    err_has 'a.h5md.part cannot be created: Read-only file system'
    out_is older
  done
  # The last row of the trajectory is not written: it is left out, whichever dataset lacks it.
  for size in 480 500 520 545 560 580; do
    disk $size "cd ..; beadswim-run $rpy -o disk/a.h5md --progress none --cycles 999 --frames-per-cycle 20; cp disk/a.h5md.part ."
    if [ ${#views[@]} -gt 0 ]; then
      run beadswim-view a.h5md.part -o a.html
      has_status 0
    fi
    run beadswim-plot trajectories a.h5md.part -o a.svg --data a.csv
    has_status 0
    check "beads jump at the end" awk -F, 'NR > 2 && ($NF - last > 1 || last - $NF > 1) { exit 1 } { last = $NF }' a.csv
  done
  disk 1200 "cd ..; beadswim-run $lbm -o disk/a.h5md --flow-every 0.1 --progress none; echo \$? >status"
  check "flow fields: status 3" test "$(<status)" = 3
  err_has 'beadswim-run: disk/a.h5md.*(is the disk full|No space left)'
else
  echo "not tried: full and read-only disks, as no mount namespace can be had here"
fi

# --- too little memory: alone, on all ranks of several, and in a program without a lattice
swimmer 400,300,300 >large.json
large="large.json -o large.h5md --cycles 0.001 --progress none"
needed='out of memory: the lattice needs about 5.7 GB on [12] ranks; use a smaller --cells-per-radius'
fails "$needed" bash -c "ulimit -v 1000000; beadswim-run $large"
fails "$needed" bash -c "ulimit -v 1000000; mpirun -n 2 beadswim-run $large"
check "one rank alone reports" test "$(grep -c '^beadswim-run: out of memory' err)" -eq 1
check "Open MPI reports no abort" test "$(grep -c MPI_ABORT err)" -eq 0
fails 'out of memory; use fewer swimmers or lattice cells' \
  bash -c "ulimit -v 400000; beadswim-layout swarm --preset paper-uniform --blocks 40,60,40"
out_empty

# --- the folder of the output vanishes while a run writes to it
begun() { # FILE: waits until it has some contents, as the program in the background writes it
  for _ in $(seq 3000); do
    [ -s "$1" ] && return
    kill -0 $! 2>/dev/null || break
    sleep 0.02
  done
  failed "$1 was not written"
}
for ranks in 1 2; do
  for run in "$rpy --checkpoint-every 9" "$lbm --flow-every 9" "$lbm --checkpoint-every 9" "$rpy"; do
    mkdir gone
    quietly $ranks $run -o gone/a.h5md --cycles 100 >out 2>err &
    begun gone/a.h5md.part
    mv gone vanished
    rm -rf vanished
    status=0
    wait $! || status=$?
    command_line="the folder vanishes of mpirun -n $ranks beadswim-run $run"
    has_status 3
    out_empty
    err_has '^beadswim-run: (the complete trajectory )?gone/a.h5md.*(No such file|cannot be created)'
    check "one rank alone fails: Open MPI reports no abort" test "$(grep -c MPI_ABORT err)" -eq 0
  done
done

# --- a rank dies: what was there stays, and the run goes on from the last checkpoint
for run in "$rpy" "$lbm"; do
  quietly 2 $run -o whole.h5md --cycles 60 >whole.json
  rm -f killed*.h5md*
  cp run.h5md killed$$.h5md
  mpirun -n 2 beadswim-run $run -o killed$$.h5md --cycles 60 --checkpoint-every 1 --progress none >out 2>err &
  begun killed$$.h5md.ckpt.1
  kill -KILL "$(pgrep -f "^beadswim-run .*killed$$.h5md" | tail -1)"
  status=0
  wait $! || status=$?
  command_line="kill -KILL (one of 2 ranks of beadswim-run $run)"
  has_status 137
  err_has 'exited on signal 9'
  out_empty
  check "the older trajectory is there" cmp -s run.h5md killed$$.h5md
  run quietly 2 --restart killed$$.h5md
  has_status 0
  check "the record is that of an unbroken run" cmp -s whole.json out
  check "so are all datasets" h5diff whole.h5md killed$$.h5md
done

# --- a checkpoint vanishes: the other serves; both: so it is said
newest=$(ls -t killed$$.h5md.ckpt.? | head -1)
rm "$newest"
run quietly 2 --restart killed$$.h5md --cycles 61
has_status 0
rm killed$$.h5md.ckpt.?
refuses 'has no checkpoint to continue from' beadswim-run --restart killed$$.h5md --cycles 62

finish
