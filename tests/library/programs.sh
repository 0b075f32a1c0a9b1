#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The programs of docs/library.md, built against an installed libsmc as its page says: each prints what the page shows.
#     programs.sh MAKE B CC
make=$1 build=$2 cc=$3
. tests/checks.sh
root=$(pwd)
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

# extract FENCE: the first block of that fence.
extract() { awk -v fence="\`\`\`$1" '$0 == fence { inside = 1; next } /^```/ { if (inside) exit } inside' "$root/docs/library.md"; }
prints() { "$@" >out && cmp expected out; }

check "make install" "$make" -s B="$build" CC="$cc" PREFIX="$dir/inst" install
cp examples/tank/tank.sm "$dir"
cd "$dir" || exit 1
extract text >expected
check "the page shows what the programs print" test "$(wc -l <expected)" -eq 5
extract "c tank.c" >tank.c
flags="-I$dir/inst/include -L$dir/inst/lib -lsmc"
if has pkg-config; then
    PKG_CONFIG_PATH=$dir/inst/lib/pkgconfig
    export PKG_CONFIG_PATH
    flags=$(pkg-config --cflags --libs smc | tr -d '"')
else
    skip "pkg-config (apt-get install pkg-config)"
fi
LD_LIBRARY_PATH=$dir/inst/lib
export LD_LIBRARY_PATH
case $cc in *-fsanitize*) skip "programs that load a library with sanitizers"; finish library-programs; exit ;; esac
check "C" sh -c "$cc -std=c99 -pedantic -Wall -Wextra -Werror -o tank_c tank.c $flags"
check "C runs" prints ./tank_c
check "C with the archive" sh -c "$cc -std=c99 -o tank_a tank.c -I$dir/inst/include $dir/inst/lib/libsmc.a"
check "which runs without the shared library" prints env LD_LIBRARY_PATH= ./tank_a
check "the archive beside another VM" sh -c "$cc -std=c99 -o both tank.c -I$dir/inst/include $dir/inst/lib/libsmc.a -Wl,--whole-archive $dir/inst/lib/libsmvm.a -Wl,--no-whole-archive"
if has "${CXX:-g++}"; then
    extract "cpp tank.cpp" >tank.cpp
    check "C++" sh -c "${CXX:-g++} -std=c++11 -pedantic -Wall -Wextra -Werror -o tank_cpp tank.cpp $flags"
    check "C++ runs" prints ./tank_cpp
else
    skip "C++ (apt-get install g++)"
fi
if has python3; then
    extract "python tank.py" >tank.py
    check "Python runs" prints python3 tank.py
    if python3 -c 'import cffi' 2>/dev/null; then
        cat >header.py <<'EOF'
import subprocess, sys, cffi
text = subprocess.run(sys.argv[2:] + ["-E", "-std=c99", sys.argv[1]], capture_output=True, text=True, check=True).stdout
own, inside = [], False
for line in text.splitlines():
    if line.startswith("# "):
        inside = line.split('"')[1].endswith("/smc.h")
    elif inside and not line.startswith("#"):
        own.append(line)
ffi = cffi.FFI()
ffi.cdef("\n".join(own))
smc = ffi.dlopen("libsmc.so.1")
s = ffi.new("SmcSession **")
assert smc.smc_open(ffi.NULL, 0, s) == smc.SMC_OK and smc.smc_compile(s[0]) == smc.SMC_E_STATE and smc.smc_close(s[0]) == 0
EOF
        check "cffi reads the header" python3 header.py "$dir/inst/include/smc.h" $cc
    else
        skip "cffi (apt-get install python3-cffi)"
    fi
else
    skip "Python (apt-get install python3)"
fi
if has bindgen && has rustc; then
    extract "rust tank.rs" >tank.rs
    check "bindgen reads the header" bindgen "$dir/inst/include/smc.h" -o smc.rs
    check "Rust" rustc tank.rs -L native="$dir/inst/lib" -l smc -o tank_rs
    check "Rust runs" prints ./tank_rs
else
    skip "Rust (apt-get install bindgen rustc)"
fi
if has mcs && has mono; then
    extract "csharp tank.cs" >tank.cs
    check "C#" mcs tank.cs -out:tank.exe
    check "C# runs" prints env LANG=C mono tank.exe
else
    skip "C# (apt-get install mono-mcs mono-runtime)"
fi
finish library-programs
