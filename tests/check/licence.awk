# SPDX-License-Identifier: Apache-2.0
# Every source file bears the licence on its first line, or behind a #! line.  Input: the names of the files, one a line.
{
    file = $0
    line = ""
    getline line < file
    if (line ~ /^#!/)
        getline line < file
    close(file)
    if (line ~ /SPDX-License-Identifier: Apache-2\.0/)
        good++
    else {
        print file ": the first line is not its licence"
        bad++
    }
}
END {
    print good + 0 " passed, " bad + (good == 0) " failed"
    exit bad > 0 || good == 0
}
