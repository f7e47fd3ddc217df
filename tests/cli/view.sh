#!/bin/bash
# Tests beadswim-view: the data in its pages must be those of the trajectory. tests/view tests the pages in a browser.
source "$(dirname "$0")/harness.sh"

beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,1 | beadswim-layout defect jitter --sigma 0.5 --seed 1 >swarm.json 2>err
beadswim-run swarm.json --model rpy -o swarm.h5md --cycles 1.5 --progress none >swarm.record 2>err
views swarm.h5md swarm.html || skip "$(cat err)"
err_empty
out_empty

# --- what the page holds is what h5dump reads of the file, to half a step of its 16 bits
for name in position image; do
  h5dump -d "/particles/beads/$name/value" -b LE -o $name.bin swarm.h5md >/dev/null
done
cat >hold.py <<'PYTHON'
import array, base64, json, re, sys
page, swimmers, box = open("swarm.html").read(), 4, (96, 64, 64)
kinds = {"float": "f", "int": "h"}
def block(name, kind):
    numbers = array.array(kinds[kind])
    numbers.frombytes(base64.b64decode(re.search(f'<script type="text/plain" id="{name}">([^<]*)</script>', page)[1], validate=True))
    return numbers
def raw(name, kind):
    numbers = array.array(kind)
    numbers.frombytes(open(name, "rb").read())
    return numbers
wrapped, image = raw("position.bin", "f"), raw("image.bin", "i")
truth = [x + n * box[i % 3] for i, (x, n) in enumerate(zip(wrapped, image))]
scene = json.loads(re.search('id="scene">([^<]*)</script>', page)[1])
start, step, row = block("start", "float"), block("step", "float"), 9 * swimmers
worst = 0
for frame in range(len(scene["times"])):
    for i, steps in enumerate(block(f"frame-{frame}", "int")):
        quantum = step[i // 9]
        worst = max(worst, abs(start[i] + steps * quantum - truth[frame * row + i]) / (0.5 * quantum + 2e-5))
print(len(scene["times"]), worst)
record = json.load(open("swarm.record"))
v_step, v = block("cycle-velocity-step", "float"), block("cycle-velocity", "int")
for s, swimmer in enumerate(record["swimmers"]):
    cycle = swimmer["cycles"][0]
    expected = cycle["velocity"][0] - cycle["mean_flow"][0]
    worst = max(worst, 0 if abs(v[s] * v_step[s] - expected) < 1e-3 * abs(expected) else 99)
sys.exit(worst > 1 or len(scene["times"]) != 61 or len(truth) != 61 * row)
PYTHON
run python3 hold.py
has_status 0
check "the page's policy lets scripts of others run" \
  grep -qE "content=\"default-src 'none'; script-src 'sha256-[A-Za-z0-9+/=]+'; style-src 'sha256-[A-Za-z0-9+/=]+'; img-src data:; base-uri 'none'" swarm.html
check "the page names a place in the network" test "$(grep -oE '(src|href)="?https?:' swarm.html | wc -l)" -eq 0

# --- the same bytes, to a file and to standard output; a part of a run; every so many frames
same_bytes 'cat swarm.html' 'beadswim-view swarm.h5md -o -'
cp swarm.h5md going.h5md.part
same_bytes 'beadswim-view going.h5md.part -o - | sed s/going.h5md.part/X/' 'beadswim-view swarm.h5md -o - | sed s/swarm.h5md/X/'
accepts beadswim-view swarm.h5md -o few.html --every 25
check "frames 0, 25, 50 and the last are not those shown" holds '[.times[] | . * 1e6 | round] == [0, 625000, 1250000, 1500000]' \
  <(grep -oE 'id="scene">[^<]*' few.html | sed 's/^[^>]*>//')
accepts beadswim-view swarm.h5md -o ids.html --block-swimmers 2
check "blocks are not by id" holds '.blocks == [0, 0, 1, 1]' <(grep -oE 'id="scene">[^<]*' ids.html | sed 's/^[^>]*>//')

# --- a run shorter than a cycle, one frame alone, and names that HTML could take for its own
beadswim-run swarm.json --model rpy -o '<b>&.h5md' --cycles 0.1 --progress none >short.record 2>err
accepts beadswim-view '<b>&.h5md' -o short.html --every 100
check "the name is not kept" holds '.file == "<b>&.h5md" and .cycle_times == []' <(grep -oE 'id="scene">[^<]*' short.html | sed 's/^[^>]*>//')

# --- the flow: every third cell of the file along each axis, without cells in the bead and hidden ones
beadswim-layout shape sphere --unbounded >sphere.json
flow_of() { # NAME FLAGS...   prints the last flow file
  beadswim-run sphere.json --model rpy --cycles 1 --progress none -o "$1.h5md" "${@:2}" >"$1.record" 2>err
  ls "$1".h5md.flow/*.vti | tail -1
}
region="--flow-region=-36:44,-30:30,-30:30 --flow-spacing 2"
flow=$(flow_of sphere --flow-every 1 $region)
cat >arrows.py <<'PYTHON'
import array, base64, json, re, sys
from flow_files import centres, read_vti
def arrows(name):
    page = open(name).read()
    def rows(id):
        numbers = array.array("f", base64.b64decode(re.search(f'id="{id}">([^<]*)</script>', page)[1]))
        return list(zip(*(numbers[k::3] for k in range(3))))
    return json.loads(re.search('id="scene">([^<]*)</script>', page)[1])["flow"], rows("flow-place"), rows("flow-velocity")
cells, spacing, origin, fields = read_vti(sys.argv[1])
places = centres(cells, spacing, origin)
for page, low in (("flow.html", -99), ("hidden.html", 4)):
    scene, at, velocity = arrows(page)
    shown = [n for n, (x, y, z) in enumerate(places)
             if all(((p - o) / spacing - 0.5 - (c - 1) % 3 // 2) % 3 == 0 for p, o, c in zip(places[n], origin, cells))
             and fields["bead"][n] == 0 and x > low]
    assert scene == {"arrows": len(shown), "spacing": 3 * spacing, "mean_cycles": None}, scene
    assert at == [places[n] for n in shown] and velocity == [fields["velocity"][n] for n in shown]
    print(page, len(shown), "arrows")
PYTHON
python3 - "$flow" <<'PYTHON' # hides the cells with x < 4, half of each row of 40
import base64, sys
flags = bytes(8 * (n % 40 < 20) for n in range(40 * 30 * 30))
data = base64.b64encode(len(flags).to_bytes(8, "little") + flags).decode()
field = f'        <DataArray type="UInt8" Name="vtkGhostType" NumberOfComponents="1" format="binary">\n{data}\n        </DataArray>\n'
open("hidden.vti", "w").write(open(sys.argv[1]).read().replace("      </CellData>", field + "      </CellData>"))
PYTHON
accepts beadswim-view sphere.h5md -o flow.html --flow "$flow"
accepts beadswim-view sphere.h5md -o hidden.html --flow hidden.vti
run python3 arrows.py "$flow"
has_status 0
mean=$(flow_of mean --flow-mean 1 $region)
accepts beadswim-view mean.h5md -o mean.html --flow "$mean"
check "the mean is not named" holds '.flow.mean_cycles == 1' <(grep -oE 'id="scene">[^<]*' mean.html | sed 's/^[^>]*>//')

# --- what cannot be shown
echo kept >kept.html
refuses 'absent.h5md: the file cannot be read' beadswim-view absent.h5md -o kept.html
h5copy -i swarm.h5md -o foreign.h5md -s /h5md -d /h5md
refuses 'foreign.h5md: the file is an HDF5 file but not a trajectory of Beadswim: the group /particles is missing; give a trajectory file of beadswim-run' \
  beadswim-view foreign.h5md -o kept.html
refuses 'swarm.json: the file is not an HDF5 file' beadswim-view swarm.json -o kept.html
refuses '--output: the file name "page.svg" does not end in .html; give a name that ends in .html' beadswim-view swarm.h5md -o page.svg
refuses 'absent.vti: the file cannot be read' beadswim-view sphere.h5md -o kept.html --flow absent.vti
head -c 3000 "$flow" >cut.vti
refuses 'cut.vti: .*; give a flow file \(.vti\) as beadswim-run wrote it' beadswim-view sphere.h5md -o kept.html --flow cut.vti
refuses 'vti: the flow is in the frame of swimmer 0, but the page shows the box; give a flow file of a run without --flow-frame' \
  beadswim-view sphere.h5md -o kept.html --flow "$(flow_of turned --flow-every 1 --flow-frame swimmer $region)"
refuses 'vti: all cells of the flow lie in beads or are hidden; give a flow file with fluid' \
  beadswim-view sphere.h5md -o kept.html --flow "$(flow_of inside --flow-every 1 --flow-region=4:4,0:0,0:0)"
sed '3 s/Origin="[^"]*"/Origin="9000 0 0"/' "$flow" >far.vti
refuses 'far.vti: the flow around \(9040, 30, 30\) is far from the swimmers around \(0, 0, 0\); give a flow file of the same run' \
  beadswim-view sphere.h5md -o kept.html --flow far.vti
refuses '--every' beadswim-view swarm.h5md -o kept.html --every 0
refuses '--block-swimmers' beadswim-view swarm.h5md -o kept.html --block-swimmers 1,2
refuses '--evry: unknown flag; did you mean --every' beadswim-view swarm.h5md -o kept.html --evry 2
refuses '--output: required but not given; see "beadswim-view --help"' beadswim-view swarm.h5md
refuses 'no/such/folder' beadswim-view swarm.h5md -o no/such/folder/page.html
check "what was there is gone" test "$(cat kept.html)" = kept

# --- a build without Node.js has a program that says so; the next build tries again
run cmake -DNODE= -DNPM= -DSOURCE="$BEADSWIM_SOURCE/tools/view/page" -DFOLDER="$PWD/page" -DOUTPUT="$PWD/page.cpp" -DSTAMP="$PWD/page.built" -P "$BEADSWIM_SOURCE/cmake/BuildPage.cmake"
has_status 0
err_has 'beadswim-view will have no page: Beadswim was built without Node.js'
check "the page's absence does not compile" ${CXX:-c++} -std=c++20 -fsyntax-only -I "$BEADSWIM_SOURCE/tools/view" page.cpp
check "the page's absence passes for a page" test ! -e page.built

finish
