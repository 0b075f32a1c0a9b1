# SPDX-License-Identifier: Apache-2.0
# The project speaks of itself only: no file names a folder of somebody's machine.  Input: the names of the files, one a line.
BEGIN {
    # Temporary and home folders followed by a name; written so that this file does not find itself.
    pattern = "(^|[^A-Za-z0-9_.])/(tmp|work|home|root|Users)[/][A-Za-z0-9]"
}
{
    file = $0
    before = bad
    for (n = 1; (getline line < file) > 0; n++)
        if (line ~ pattern) {
            print file ":" n ": " line
            bad++
        }
    close(file)
    good += bad == before
}
END {
    print good + 0 " passed, " bad + (good == 0) " failed"
    exit bad > 0 || good == 0
}
