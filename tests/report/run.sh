#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Pages of smc report: run.sh SMC FOLDER.  They are well-formed, load and run nothing, and have the same bytes wherever they are written.  A
# browser shows and prints them (chromium; without one that part is skipped).
smc=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
out=${2:?run.sh SMC FOLDER}
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
passed=0 failed=0 skipped=0
rm -rf "$out" && mkdir -p "$out/other" || exit 3
out=$(cd "$out" && pwd)

expect() {
    test_name=$1
    shift
    if "$@" >"$out/log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$test_name: $*"
        head -20 "$out/log"
    fi
}

ends_with() { want=$1; shift; "$@"; test $? -eq "$want"; }

# page NAME EXIT ARGUMENT...: makes NAME.html twice, in two folders, from sources under two paths.
page() {
    name=$1 want=$2
    shift 2
    expect "report $name" ends_with "$want" "$smc" report "$@" -o "$out/$name.html"
    expect "no table of $name is empty" sh -c "! tr -d '\n' <'$out/$name.html' | grep -q '<tbody></tbody>'"
    expect "wellformed $name" awk -f "$here/wellformed.awk" "$out/$name.html"
    case $1 in "$out"/many/*) cp -r "$out/many" "$out/other/$name" ;; "$out"/*) mkdir "$out/other/$name" && cp "$1" "$out/other/$name" ;; "$root"/*) cp -r "$(dirname "$1")" "$out/other/$name" ;; *) mkdir "$out/other/$name" && cp "$1" "$out/other/$name" ;; esac
    twin=
    for argument; do
        case $argument in
            --sv=*) twin="$twin --sv=$out/other/$name/$(basename "${argument#--sv=}")" ;;
            -*) twin="$twin $argument" ;;
            *) twin="$twin $out/other/$name/$(basename "$argument")" ;;
        esac
    done
    # shellcheck disable=SC2086
    (cd "$out/other" && "$smc" report $twin -o twin.html >/dev/null 2>&1)
    expect "same bytes $name" cmp "$out/$name.html" "$out/other/twin.html"
}

examples=$root/examples
page tank 0 "$examples/tank/tank.sm" "$examples/tank/tank.ss"
page everything 0 "$examples/tank/tank.sm" "$examples/tank/tank.ss" "$examples/tank/tank.rq" --all
page chilldown 0 "$examples/chilldown/chilldown.sm" "$examples"/chilldown/chilldown*.ss
page ignition 0 "$examples/ignition/ignition.sm" "$examples"/ignition/ignition*.ss
page parachutes 0 "$examples/parachutes/parachutes.sm" "$examples"/parachutes/parachutes*.ss
page mission 0 "$examples/mission/mission.sm" "--sv=$examples/mission/rocket.sv" "$examples"/mission/mission*.ss
# Of an application: each machine has a chapter, and each link leads to its own sections.
page application 0 "$examples/dualdeploy/dualdeploy.app" "$examples"/dualdeploy/dualdeploy*.ss "$examples/dualdeploy/dualdeploy.rq" --mutate --faults --sweep
grep -o ' id="[^"]*"' "$out/application.html" | sed 's/ id="//; s/"$//' | sort >"$out/ids"
grep -o ' href="#[^"]*"' "$out/application.html" | sed 's/ href="#//; s/"$//' | sort -u >"$out/links"
expect "ids of an application exist once" sh -c "test -z \"\$(uniq -d '$out/ids')\""
expect "links of an application lead somewhere" sh -c "test -z \"\$(sort -u '$out/ids' | comm -13 - '$out/links')\""
expect "an application has at least 70 links" sh -c "test \$(wc -l <'$out/links') -ge 70"
# Four scripts: the pages of the print are counted below.
page four-scripts 0 "$examples/mission/mission.sm" "--sv=$examples/mission/rocket.sv" "$examples"/mission/mission.ss \
    "$examples"/mission/mission-accelerometer-broken.ss "$examples"/mission/mission-plugged-in.ss "$examples"/mission/mission-weak-motor.ss
page airbrakes 0 "$examples/mission/airbrakes.sm" "--sv=$examples/mission/rocket.sv" "$examples"/mission/airbrakes*.ss
# More inputs than the matrix of faults has room for: the worst first, and the others counted.  Long lists are folded.
mkdir "$out/many"
{
    printf '[options]\nstep 10 ms\n[state_vector]\nU64 G\nU32 S\nbool valve\n'
    for i in $(seq 10 54); do echo "F64 s$i @read_only @range 0 100"; done
    printf '[Run]\n.step\n    valve = s52 > 80 or s53 > 120\n'
    for i in $(seq 10 51); do echo "    s$i > 90: -> Stop"; done
    printf '[Stop] @abort @safe\n.entry\n    valve = false\n'
} >"$out/many/sensors.sm"
{
    printf '[all_states]\n'
    for i in $(seq 10 54); do echo "true: s$i = 50"; done
    echo 'at 200: @stop'
} >"$out/many/sensors.ss"
echo 'R1 "never open"  never valve' >"$out/many/sensors.rq"
page sensors 0 "$out/many/sensors.sm" "$out/many/sensors.ss" "$out/many/sensors.rq" --faults --mutate
expect "sensors: the worst input first" sh -c "tr -d '\n' <'$out/sensors.html' | grep -q '<tbody><tr><td[^>]*><code[^>]*>s52<'"
expect "sensors: inputs that are left out" grep -q '4 more inputs are left out: the worst of theirs is <code>' "$out/sensors.html"
expect "sensors: folded rows" grep -q '<details><summary>[1-9][0-9]* more rows</summary>' "$out/sensors.html"
"$smc" report "$out/many/sensors.sm" "$out/many/sensors.ss" "$out/many/sensors.rq" --faults --mutate --format=json >"$out/sensors.json" 2>/dev/null
expect "sensors: each line of the list is on the page, folded or not" test \
    "$(grep -o ' id="fault-[0-9]*"' "$out/sensors.html" | sort -u | wc -l)" -eq "$(grep -o '"effect":' "$out/sensors.json" | wc -l)"

page hostile 1 "$here/hostile.sm" "$here/hostile.ss" "$here/failing.ss"
page twostage 0 "$root/tests/graph/machines/twostage.sm"
page all_states 0 "$root/tests/graph/machines/all_states.sm"
page rocket 0 "$examples/rocket/mission.sm" "--sv=$examples/rocket/rocket.sv"
printf '[state_vector]\nU64 G\nU32 S\n[A]\n.step\n' >"$out/nothing.sm"
page nothing 0 "$out/nothing.sm"
page alone 0 "$examples/tank/tank.sm"

# A sweep that is stopped says so, and does not say that nothing can be swept: the time is not enough for 21 runs.
printf '[options]\nstep 10 ms\n[state_vector]\nU64 G\nU32 S\nF64 x\n[local]\nF32 burn = 8 @parameter @range 1 15\n[A]\n.step\nx = roll_avg(G * burn, 50)\n' >"$out/slow.sm"
printf '[all_states]\nat 9000 s: @stop\n' >"$out/slow.ss"
expect "a sweep that is stopped" ends_with 0 sh -c "'$smc' report '$out/slow.sm' '$out/slow.ss' --sweep --time=1 -o '$out/slow.txt' 2>'$out/slow.note'"
expect "its note" grep -q 'stopped before it was complete: margins of 1 of 1 parameters' "$out/slow.note"
expect "its verdict" grep -q '^  Parameters  *open  *1 not known: stopped before' "$out/slow.txt"
expect "its section" grep -q 'Stopped before it was complete, so nothing is known of: burn' "$out/slow.txt"
expect "no false statement about it" ends_with 1 grep -q 'has no parameter\|none can be set' "$out/slow.txt"

# The same for changes of the machine: how many of how many were tried, wherever a score is.
for i in 1 2 3 4 5 6 7 8 9; do
    echo "x = x + roll_avg(G * burn > $i and T < $i or x > 5, 50) * $i"
done >>"$out/slow.sm"
expect "changes that are stopped" ends_with 0 sh -c "'$smc' report '$out/slow.sm' '$out/slow.ss' --mutate --time=1 -o '$out/slow.txt' 2>'$out/slow.note'"
expect "their note" grep -q 'changes that no script notices ([0-9]* of [0-9]* tried)' "$out/slow.note"
expect "their verdict" grep -q '^  Changes that scripts notice  *open .*only [0-9]* of [0-9]* were tried' "$out/slow.txt"
expect "their section" grep -q 'only [0-9]* of [0-9]* changes were' "$out/slow.txt"

# A short script has tried all changes at once.  What takes longer is the search among those that it does not notice.
printf '[all_states]\nG == 0: @stop\n' >"$out/short.ss"
expect "a search that is stopped" ends_with 0 sh -c "'$smc' report '$out/slow.sm' '$out/short.ss' --mutate --time=1 -o '$out/slow.txt' 2>'$out/slow.note'"
expect "its note" grep -q 'the search for changes that make no difference (all [0-9]* were tried)' "$out/slow.note"

# Not everything is never 100 %: here 904 of 907 places, which are 99.67 %.
{
    printf '[options]\nstep 10 ms\n[state_vector]\nU64 G\nU32 S\nU8 x\n[A]\n.step\n'
    for i in $(seq 1 150); do echo "G >= $((i * 10)): x = $i"; done
    echo 'G > 5000: x = 0'
} >"$out/nearly.sm"
printf '[all_states]\nat 2 s: @stop\n' >"$out/nearly.ss"
expect "nearly all" "$smc" report "$out/nearly.sm" "$out/nearly.ss" -o "$out/nearly.txt"
expect "is not 100 %" grep -q '^  Coverage  *open  *[0-9]* of [0-9]* places (99 %)' "$out/nearly.txt"

# The messages of an application.
cat >"$out/rocket.net" <<'END'
send telemetry every 20 ms on tcp 5000 @peers 2 { [Sensors] }
send beacon every 500 us to 239.1.2.3:5001 { altitude }
receive clock from tcp 10.0.0.9:5002 @timeout 1 s { umbilical @safe true velocity @default -1.5 acceleration @hold brakeOrder }
END
expect "report with messages" "$smc" report "$examples/mission/mission.sm" "--sv=$examples/mission/rocket.sv" "--net=$out/rocket.net" -o "$out/messages.html"
expect "wellformed messages" awk -f "$here/wellformed.awk" "$out/messages.html"
expect "messages as text" "$smc" report "$examples/mission/mission.sm" "--sv=$examples/mission/rocket.sv" "--net=$out/rocket.net" -o "$out/messages.txt"
for line in "telemetry  sent       TCP, listens on port 5000 for 2  20  *33  umbilical, acceleration, velocity, altitude" \
    "beacon     sent       UDP, to 239.1.2.3:5001  *0.5  *24  altitude" "clock      received   TCP, connects to 10.0.0.9:5002  *1000  *33" \
    "umbilical     clock        true, also before the first one" "velocity      clock        -1.5" "acceleration  clock        keeps its value" \
    "brakeOrder    clock        NaN, which reads as 0"; do
    expect "a line of the messages" grep -q "$line" "$out/messages.txt"
done
expect "no messages without --net" ends_with 1 grep -q '>Messages<' "$out/mission.html"
expect "--net without --sv" ends_with 2 "$smc" report "$examples/mission/mission.sm" "--net=$out/rocket.net"
echo 'send beacon every 1 s to 10.0.0.2:1 { nowhere }' >"$out/wrong.net"
expect "messages with an error" ends_with 1 "$smc" report "$examples/mission/mission.sm" "--sv=$examples/mission/rocket.sv" "--net=$out/wrong.net"

# On paper, long names can be divided between their words, and short ones cannot.  Options keep their hyphens.
page stand 0 "$examples/teststand/stand.sm" "--sv=$examples/teststand/teststand.sv" "$examples"/teststand/stand*.ss
page longnames 0 "$here/longnames.sm"
page mutated 0 "$examples/parachutes/parachutes.sm" "$examples/parachutes/parachutes.ss" --mutate
expect "a long name is divided" grep -q '<code>chamber<wbr/>PressureA</code>' "$out/stand.html"
expect "an arrow is not divided" grep -q '<span class="b">-&gt;</span> Idle' "$out/everything.html"
expect "titles of many columns are written downwards" grep -q '<table class="narrow dense upright">' "$out/longnames.html"
expect "those of few are not" grep -q '<table class="narrow dense">' "$out/stand.html"
expect "a short one is not" grep -q '<code>leastTank</code>' "$out/stand.html"
expect "an option is not divided" grep -q '<code class="b">--mutate</code>' "$out/stand.html"
expect "inputs that would show a change are on a screen only" grep -q '<td class="screen">from Pad, at G = ' "$out/mutated.html"

# A diagram that is readable on part of a page is marked as low, others are not.
expect "a low diagram" grep -q '<figure class="diagram low"' "$out/tank.html"
expect "a diagram that is legible on a page of its own only" sh -c "! grep -q '<figure class=\"diagram low\"' '$out/chilldown.html'"
expect "a large diagram has slices for paper" test "$(grep -c '^<svg' "$out/twostage.html")" -ge 4
expect "it is printed on landscape pages" grep -q '<figure class="diagram large"' "$out/twostage.html"
expect "a diagram without slices" sh -c "! grep -q '<div class=\"print\"' '$out/tank.html'"
expect "a diagram that is not low" grep -q '<figure class="diagram"' "$out/mission.html"
# Letters of a diagram have at least 6 points on paper: no slice is wider than 1,393 pixels, which a landscape page scales to 73 %.
page star 0 "$root/tests/graph/machines/star.sm"
slices_fit() { grep -o '^<svg[^>]* width="[0-9]*"' "$1" | tail -n +2 | sed 's/.*width="//; s/"//' | awk '$1 > 1393 { wide++ } END { exit NR < 2 || wide }'; }
expect "slices of a wide diagram fit on a page" slices_fit "$out/star.html"
expect "slices without a text are left out" test "$(grep -c '^<svg' "$out/star.html")" -eq 4
expect "a screen shows it at 80 % of its width at least" grep -q '<figure class="diagram large" style="--width:1[0-9]*px">' "$out/star.html"

# The JSON is valid, if python3 exists to check it.
if command -v python3 >/dev/null; then
    for machine in tank/tank ignition/ignition; do
        expect "json $machine" sh -c "'$smc' report '$examples/$machine.sm' '$examples/$machine.ss' --format=json | python3 -m json.tool"
    done
    expect "json hostile" sh -c "'$smc' report '$here/hostile.sm' '$here/hostile.ss' --format=json | python3 -m json.tool"
fi

# A page or a picture is not written to a terminal (`script` provides one).
if command -v script >/dev/null; then
    for command in report graph; do
        script -qec "'$smc' $command '$root/examples/tank/tank.sm'" /dev/null >"$out/terminal" 2>&1 </dev/null
        expect "$command at a terminal" test "$?" = 2
        expect "$command at a terminal says what to do" grep -q "this output is for a browser, not for a terminal; name a file, as in -o tank\." "$out/terminal"
    done
else
    skipped=$((skipped + 1))
    echo "there is no `script`: commands at a terminal are not tested"
fi

# A browser draws it, and prints it on paper.
browser=
for b in chromium chromium-browser google-chrome; do
    command -v $b >/dev/null && { browser=$b; break; }
done
drawn() {           # NAME: the picture is a PNG of the page
    if command -v python3 >/dev/null; then
        python3 "$here/png.py" "$out/$1.png" 1200 4000
    else
        test "$(od -An -tx1 -N24 "$out/$1.png" | tr -d ' \n')" = 89504e470d0a1a0a0000000d49484452000004b000000fa0
    fi
}
# PAGES of a PDF, at least one.
pages() { grep -ac '/Type /Page$' "$1"; }
no_more_pages() { test "$(pages "$1")" -ge 1 && test "$(pages "$1")" -le "$2"; }
shown() {
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1200,4000 "$2" "file://$1" >/dev/null 2>&1
}
# measured NAME WIDTH MEDIUM: in a window of this width, or on paper of it, nothing of the page is too wide, covered or blank.
measured() {
    {
        case $3 in
            paper) sed 's/@media *print/@media all/; s/@media screen/@media not all/; /Content-Security-Policy/d' "$out/$1.html" ;;
            *) sed '/Content-Security-Policy/d' "$out/$1.html" ;;
        esac
        echo '<script>' && cat "$here/measure.js" && echo '</script>'
    } >"$out/measured.html"
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size="$2",720 --dump-dom "file://$out/measured.html" 2>/dev/null |
        sed -n 's|.*<title>\(wide.*\)</title>.*|\1|p' >"$out/measures"
    cat "$out/measures"
    grep -qx 'wide 0, clash 0, blank 0, pictures some' "$out/measures"
}
if [ -n "$browser" ] && timeout 60 "$browser" --headless --no-sandbox --disable-gpu --dump-dom about:blank >/dev/null 2>&1; then
    for name in hostile four-scripts; do
        expect "screenshot $name" shown "$out/$name.html" "--screenshot=$out/$name.png"
        expect "screenshot of $name shows it" drawn "$name"
        expect "print $name" shown "$out/$name.html" "--print-to-pdf=$out/$name.pdf"
        expect "print of $name is one" sh -c "head -c 5 '$out/$name.pdf' | grep -q %PDF-"
    done
    # On a projector, and on the width between the margins of A4 and of Letter.
    for name in longnames stand everything star; do
        expect "$name at 1280 pixels" measured "$name" 1280 screen
        expect "$name on A4" measured "$name" 688 paper
    done
    expect "long names on Letter" measured longnames 710 paper
    # One section does not turn another to landscape, and tables are divided between pages.
    expect "print stand" shown "$out/stand.html" "--print-to-pdf=$out/stand.pdf"
    expect "pages of the test stand" no_more_pages "$out/stand.pdf" 26
    # On paper the diagram is on the first page, and no section begins a new one. What is not covered takes a page of the twelve, what each output is in each state half a page.
    expect "pages of four scripts" no_more_pages "$out/four-scripts.pdf" 12
    # The browser's own tree has the page, and the hostile texts as texts: no element came of them.
    timeout 60 "$browser" --headless --no-sandbox --disable-gpu --dump-dom "file://$out/hostile.html" >"$out/dom.html" 2>/dev/null
    expect "the tree is that of the page" grep -q '<h1>hostile</h1>' "$out/dom.html"
    expect "hostile texts are texts in it" grep -q '&lt;script&gt;alert("head")&lt;/script&gt;' "$out/dom.html"
    expect "the tree is whole" grep -q '</html>' "$out/dom.html"
    expect "no script in the tree" sh -c "! grep -Ei '<script|<img|onerror=[^ ]*alert[^&]*\"' '$out/dom.html' | grep -v '&lt;'"
else
    skipped=$((skipped + 1))
    echo "there is no browser (chromium): pages are not shown"
fi
# The image that flies is the one of the page, with its pins.
same_image() {
    "$smc" build -w "$@" -o "$out/flies.smb" && "$smc" report "$@" --format=text >"$out/flies.txt" 2>&1 || return 1
    grep -q "Image CRC *$("$smc" disasm "$out/flies.smb" | sed -n 's/.*, crc \(.*\)/\1/p')\$" "$out/flies.txt"
}
expect "the image" same_image "$root/examples/tank/tank.sm" --sv "$root/tests/avr/tank.sv"
expect "the image with pins" same_image "$root/examples/tank/tank.sm" --sv "$root/tests/avr/tank.sv" --io "$root/tests/avr/tank.io"
expect "pins want a state vector" ends_with 2 "$smc" report "$root/examples/tank/tank.sm" --io "$root/tests/avr/tank.io"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
