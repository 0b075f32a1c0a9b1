#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The Python package: its tests, its types, and its installation into an environment of its own.      run.sh MAKE B CC
# PYTHON: the interpreter.  Unless it is set, python3, or that of the system if python3 has not all packages that the tests use.
make=$1 build=$2 cc=$3
. tests/checks.sh
has_packages() { "$1" -c 'import cffi, numpy, pytest, pandas, matplotlib' 2>/dev/null; }
python=${PYTHON:-python3}
[ -n "${PYTHON:-}" ] || has_packages python3 || ! has_packages /usr/bin/python3 || python=/usr/bin/python3
root=$(pwd)
case $build in /*) library=$build/lib/libsmc.so.1 ;; *) library=$root/$build/lib/libsmc.so.1 ;; esac
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT

case $cc in *-fsanitize*) skip "Python loads no library with sanitizers"; finish python; exit ;; esac
for module in cffi numpy pytest; do
    "$python" -c "import $module" 2>/dev/null || { skip "Python (apt-get install python3-$module)"; finish python; exit; }
done
for module in pandas matplotlib; do
    "$python" -c "import $module" 2>/dev/null || skip "its tests of $module (apt-get install python3-$module)"
done

check "make builds the library" "$make" -s B="$build" CC="$cc" "$build/lib/libsmc.so.1"
passes_tests()
{
    (cd python && SMC_LIBRARY=$library PYTHONPATH=. PYTHONDONTWRITEBYTECODE=1 "$python" -m pytest) >"$dir/tests"
    status=$?
    cat "$dir/tests"
    passed_tests=$(sed -n 's/^\([0-9]*\) passed.*/\1/p' "$dir/tests")
    [ "$status" -eq 0 ] && [ "${passed_tests:-0}" -ge 30 ]
}
check "its tests pass, at least 30" passes_tests
if "$python" -c 'import mypy' 2>/dev/null; then
    check "mypy --strict" sh -c "cd python && '$python' -m mypy --cache-dir '$dir/mypy'"
else
    skip "types (apt-get install python3-mypy)"
fi

# Installs a wheel into a new environment, without a network and without the tree.  numpy and cffi are those of the interpreter.
works_alone()     # WHEEL
{
    "$python" -m venv "$dir/venv" && "$dir/venv/bin/python" -m pip install -q --no-index --no-deps --disable-pip-version-check "$1" || return 1
    packages=$("$python" -c 'import numpy, os; print(os.path.dirname(os.path.dirname(numpy.__file__)))')
    (cd "$dir" && PYTHONPATH=$packages "$dir/venv/bin/python" "$root/tests/python/installed.py" "$dir/venv")
}
# A wheel for Windows has the DLL of that machine, and no library of this system.
has_dll()         # MACHINE WHEEL
{
    "$python" -m zipfile -e "$2" "$dir/$1" && cmp "$dir/$1/smc/smc.dll" "$build/windows-$1/smc.dll" && cmp "$dir/$1/smc/smc.h" compiler/library/smc.h &&
        [ ! -e "$dir/$1/smc/libsmc.so" ]
}
if "$python" -c 'import setuptools, wheel, venv, ensurepip' 2>/dev/null; then
    check "make wheel" "$make" -s B="$build" CC="$cc" PYTHON="$python" WHEEL="$dir/wheel" PIP_FLAGS='--no-index --no-build-isolation' wheel
    check "the wheel works without the tree" works_alone "$dir/wheel/"smc-*.whl
    if command -v x86_64-w64-mingw32-gcc >/dev/null && command -v i686-w64-mingw32-gcc >/dev/null; then
        check "make wheel-windows" "$make" -s B="$build" CC="$cc" PYTHON="$python" WHEEL="$dir/windows" PIP_FLAGS='--no-index --no-build-isolation' wheel-windows
        check "64 bits: the wheel has its DLL" has_dll x86_64 "$dir/windows/"smc-*-py3-none-win_amd64.whl
        check "32 bits: the wheel has its DLL" has_dll i686 "$dir/windows/"smc-*-py3-none-win32.whl
    else
        skip "wheels for Windows (apt-get install gcc-mingw-w64-x86-64 gcc-mingw-w64-i686)"
    fi
else
    skip "its installation (apt-get install python3-venv python3-setuptools python3-wheel)"
fi
finish python
