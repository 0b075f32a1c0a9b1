#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The platform psl/sbrio with the stand-in for NI's library: what `make sbrio` builds, in real time; and the bench of the test stand, in simulated
# time, between pins of the stand-in.     run.sh MAKE BUILD CC [arm]
# With `arm` for a Cortex-A9 and in QEMU, with the platform suite; else for this computer.
make=$1 build=$2 cc=$3 target=${4:-here}
. tests/checks.sh
root=$(pwd)
dir=$build/sbrio-test/$target
rm -rf "$dir"
mkdir -p "$dir/made" || exit 1
dir=$(cd "$dir" && pwd)
cross= emulator=
if [ "$target" = arm ]; then
    export NO_MULTICAST=1                              # qemu-arm does not know the option (tests/psl/socket.c)
    cross=arm-linux-gnueabi- emulator="qemu-arm-static -L /usr/arm-linux-gnueabi"
    cc="arm-linux-gnueabi-gcc -mcpu=cortex-a9 -mfpu=vfpv3 -mfloat-abi=softfp -fno-if-conversion"
    printf '#include <errno.h>\nint main(void) { return errno; }\n' >"$dir/probe.c"
    if ! has qemu-arm-static || ! $cc "$dir/probe.c" -o "$dir/probe" 2>/dev/null; then
        skip "apt-get install gcc-arm-linux-gnueabi libc6-dev-armel-cross qemu-user-static"
        finish "sbrio-$target"
        exit
    fi
fi

# The files of a platform, except those for pins and channels.
files_of() { printf 'include runtime-c/psl/%s/psl.mk\nall:;@echo $(PSL)\n' "$1" | "$make" -s -f - | tr ' ' '\n' | grep -v '/[da]io\.c$'; }

# Where it is built, make is run again as a user would.
builds() { "$make" -s sbrio B="$build" CC="$cc" CROSS="$cross" SBRIO="$dir/stand" PSL_WATCHDOG=watchdog_process CFLAGS="-O2 -Wconversion -Werror" && test -s "$dir/stand/runtime.a"; }
again() { "$make" -s -C "$dir/stand" SMC="$(cd "$build" && pwd)/smc" SMC_MK="$root/compiler/smc.mk" CC="$cc" CROSS="$cross" PSL_WATCHDOG=watchdog_process CFLAGS="-O2 -Wconversion -Werror"; }
runs() { (cd "$dir/stand" && STANDIN_CALLS=1500 $emulator ./teststand); }
logged() { "$build/smc" log "$dir/stand/teststand.log" >"$dir/log.txt" && grep -q 'tankPressure  *F32  *39.99[0-9]* .. 39.99[0-9]*,' "$dir/log.txt" && grep -q 'the application was stopped' "$dir/log.txt"; }
# The stand-in's VI has another signature.
unfit() { sed -i 's/"001122/"221100/' "$dir/stand/NiFpga_Teststand.h" && again && ! (cd "$dir/stand" && $emulator ./teststand >out 2>&1); }
wrong_type() { sed -i 's/IndicatorI32_LineTemperature/IndicatorU32_LineTemperature/' "$dir/stand/NiFpga_Teststand.h" && ! again 2>"$dir/errors"; }
check "make sbrio" builds
check "the application runs, stops, and closes its session" runs
check "its log has what the FPGA measured" logged
check "a bitfile that does not fit the program prevents the start" unfit
check "and the console says which pin failed" grep -q 'pin 0: this platform does not support it' "$dir/stand/out"
check "a row with another type than the VI's does not compile" wrong_type
check "because of its name" grep -q 'NiFpga_Teststand_IndicatorI32_LineTemperature.* undeclared' "$dir/errors"

WARN="-Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -pedantic -Werror"
bench()
{
    "$build/smc" build examples/teststand/teststand.app -o "$dir/made" &&
        $cc -std=c99 -O2 -ffp-contract=off $WARN -DSM_NO_MAIN -I. -Itests/sbrio -I"$dir/made" -Iexamples/teststand examples/teststand/*.c "$dir/made"/*.c \
            examples/sbrio/fpga.c tests/sbrio/NiFpga.c tests/sbrio/NiFpga_TeststandVi.c tests/sbrio/bench_sim.c runtime-c/*.c stdlib/*.c \
            $(files_of sim) runtime-c/psl/linux/linux.c runtime-c/psl/sbrio/*.c -o "$dir/bench" -pthread -lrt
}
# Its number of tests counts as tests here.
runs_bench()
{
    $emulator "$dir/bench" >"$dir/bench.out" 2>&1
    tail -n 1 "$dir/bench.out" | grep -q '^340 passed, 0 failed$' || { tail -n 20 "$dir/bench.out"; return 1; }
    passed=$((passed + 339))
}
check "the bench of the test stand compiles" bench
check "every fault of the test stand has its effect" runs_bench

# In a build folder of its own, with the cross compiler as CC.
suite()
{
    "$make" -s B="$dir/build" CC="$cc" CFLAGS="-O2 -Werror" "$dir/build/psl/sbrio/suite" && $emulator "$dir/build/psl/sbrio/suite" >"$dir/suite.out" 2>&1
    code=$?
    tail -n 5 "$dir/suite.out"
    passed=$((passed + $(sed -n 's/^psl-sbrio: \([0-9]*\) passed.*/\1/p' "$dir/suite.out")))
    return $code
}
is_softfp() { arm-linux-gnueabi-readelf -A "$dir/bench" >"$dir/attributes" && grep -q 'Tag_FP_arch: VFPv3' "$dir/attributes" && ! grep -q VFP_args "$dir/attributes"; }
if [ "$target" = arm ]; then
    check "the platform suite" suite
    check "floating-point numbers are passed in integer registers" is_softfp
fi
finish "sbrio-$target"
