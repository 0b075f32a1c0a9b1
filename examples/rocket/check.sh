# SPDX-License-Identifier: Apache-2.0
# What tests/check/applications.sh checks when the rocket has flown on the desk; run by it, with its functions.
app=$folder/rocket.app

# The states of the mission, in the order of the log.
states() { "$smc" log "$1" | sed -n 's/.* mission: .* \([A-Z][a-z]*\)$/\1/p' | tr '\n' ' '; }
goes_through() { states "$1"; [ "$(states "$1")" = "Countdown Powered Coast Recovery Landed " ]; }

# altitude and trueAltitude, a line a record
altitudes() { "$smc" log "$1" --format=csv altitude trueAltitude | cut -d, -f3-; }

# The navigation is never further off than five metres, and the rocket flies higher than 400.
navigates() {
    altitudes "$1" | awk -F, 'NR > 1 { e = $1 - $2; if (e < 0) e = -e; if (e > worst) worst = e; if ($2 > top) top = $2 }
                              END    { print worst " m off, " top " m high"; exit !(worst < 5 && top > 400) }'
}

expect "profile of the flight" goes_through "$work"/first/flight.log
expect "navigation" navigates "$work"/first/flight.log

# In real time, twenty times as fast: the same flight.
faster='s/every 10 ms/every 500 us/; s/every 100 ms/every 5 ms/; s/time 1 ms/time 50 us/
s/^\[flight\].*/& @overrun catch_up 10000/'
variant linux "$app" "$faster" linux
expect "flight in real time" fly "$work/linux"
altitudes "$work/first/flight.log" >"$work/on-the-desk"
altitudes "$work/linux.flight/flight.log" >"$work/in-real-time"
expect "the same flight" cmp "$work/on-the-desk" "$work/in-real-time"

# Killed in flight and started again, it goes on where it was when the vector was kept last, and lands: the plant too, since all
# that it remembers is in the state vector.
kept='s/^log .*/&\
keep "rocket.state"/; s/^    log$/&\
every 50 ms:\
    keep/; s/^ *machine .*/& @resume/'
survives() (
    mkdir -p "$1.flight" && cd "$1.flight" || return
    "$1" &
    for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        if "$smc" log flight.log | grep -q 'Powered -> Coast'; then break; fi
        sleep 0.1
    done
    kill -9 $!
    wait $!
    "$1" || return
    states flight.log
    states flight.log | awk '{ for (i = 1; i <= NF; i++) { n = index("Countdown Powered Coast Recovery Landed", $i)
                                   if (n <= before) { again++; bad += n == 1 }
                                   before = n } }
                             END { exit !(again == 1 && !bad && $NF == "Landed") }'
)
variant kept "$app" "$faster; $kept" linux
expect "goes on after it was killed" survives "$work/kept"
expect "navigation after it was killed" navigates "$work/kept.flight/flight.log"

# As its reader would build it.
makes() {
    mkdir -p "$1" && cp "$folder"/*.* "$folder/Makefile" "$1" &&
        make -s -C "$1" ROOT="$root" SMC="$smc" CC="$cc" SMC_CFLAGS=-O1
}
expect make makes "$work/make"
expect "flight of what make built" fly "$work/make/rocket"
expect "its log is the same" cmp "$work/make/rocket.flight/flight.log" "$work/first/flight.log"
