# SPDX-License-Identifier: Apache-2.0
# Writes the recorded data of this folder, which is invented: no rocket has flown it, and no stand has measured it.
#     awk -v what=flight -f record.awk > flight.csv
#     awk -v what=stand -f record.awk > stand.csv
# The noise comes from a generator of its own, so every awk writes the same files.

function random() {
    seed = (seed * 16807) % 2147483647
    return seed / 2147483647
}

# Noise between -size and size, mostly small.
function noise(size) { return (random() + random() + random() - 1.5) * size / 1.5 }

# The altitude above the pad, in m, t seconds after ignition: thrust for 2 s, then a parabola, then 20 m/s under the drogue.
function altitude_at(t) {
    if (t < 0)
        return 0
    if (t < 2)
        return 22 * t * t
    if (t < 11.6)
        return 88 + 88 * (t - 2) - 4.9 * (t - 2) * (t - 2)
    return altitude_at(11.5999) - 20 * (t - 11.6)
}

# A row every 20 ms, as the flight computer logged it since it was switched on.
function write_flight(   i, t, time, altitude, cell) {
    print "t_ms,BARO_ALT,BATT_V,DROGUE_CMD,note"
    for (i = 0; i < 1500; i++) {
        time = 48213 + 20 * i + (random() < 0.1)              # a clock with jitter
        t = (20 * i - 3000) / 1000
        altitude = altitude_at(t) + noise(2)
        if (i % 97 == 60)
            altitude += 400                                   # a wild sample
        cell = sprintf("%.1f", altitude)
        if (i % 61 == 7)
            cell = ""                                         # the sensor did not answer
        if (i >= 420 && i < 445)
            continue                                          # the logger lost half a second
        if (i == 700)
            time -= 40                                        # the clock was set back
        print time "," cell "," sprintf("%.2f", 7.9 - t / 300) "," (i * 20 >= drogue) "," (i == 150 ? "\"ignition, ch 1\"" : "")
        if (i % 211 == 100)
            print time "," cell ",7.90," (i * 20 >= drogue) ","       # a row twice
    }
}

# A row every 5 ms, as a data acquisition with decimal commas wrote it.  The pressure is in counts of its converter.
function write_stand(   i, pressure, count, open, position, row) {
    print "time_s;PT-101;VENT_CMD;VENT_POS"
    pressure = 20
    for (i = 0; i < 2000; i++) {
        count = int((pressure + noise(0.02) + 1) * 100 + 0.5)
        if (i % 4 == 0)                                       # the controller ran every 20 ms
            open = count > 2700 ? 1 : count < 2500 ? 0 : open
        row = sprintf("%.3f;%d;%d;%.2f", 1700.25 + i * 0.005, count, open, position)
        gsub(/\./, ",", row)
        print row
        pressure += open ? -0.02 : 0.012
        position += (open - position) * 0.08
    }
}

BEGIN {
    seed = 20240611
    drogue = 14980                                            # when the flight computer fired the drogue, ms after the first row
    if (what == "flight")
        write_flight()
    else
        write_stand()
}
