#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the suite of the Linux platform on a real kernel with digital pins (PL061) and a watchdog (softdog), in QEMU.
#     qemu.sh FOLDER SUITE SUITE-WATCHDOG INIT     static programs for armhf, made by `make psl-qemu`; FOLDER: for temporary files
# KERNEL is the folder that a Debian package linux-image-*-armmp was unpacked into (dpkg-deb -x).
qemu=qemu-system-arm
skip() { echo "$*: 0 passed, 0 failed, 1 skipped"; exit 0; }
command -v $qemu >/dev/null || skip "no $qemu here"
image=$(ls "${KERNEL:-/nowhere}"/boot/vmlinuz-* 2>/dev/null | tail -n 1)
[ -n "$image" ] || skip "KERNEL names no unpacked linux-image-armmp"
for tool in cpio "busybox cpio" ""; do command -v ${tool%% *} >/dev/null && break; done
[ -n "$tool" ] || skip "no cpio here"

root=$1/root
rm -rf "$root" && mkdir -p "$root" || exit 1
cp "$2" "$root/suite" && cp "$3" "$root/suite-watchdog" && cp "$4" "$root/init" || exit 1
find "$KERNEL/lib/modules" -name 'softdog.ko' -exec cp {} "$root/" \;
(cd "$root" && find . | $tool -o -H newc 2>/dev/null) | gzip >"$1/initrd" || exit 1

timeout 120 $qemu -M virt -m 256 -kernel "$image" -initrd "$1/initrd" -append "console=ttyAMA0 quiet panic=-1" \
    -nographic -monitor none -no-reboot </dev/null >"$1/log" 2>&1
grep -a 'failed:\|skipped' "$1/log"
passed=$(grep -a 'passed, .* failed' "$1/log" | sed 's/.*: \([0-9]*\) passed.*/\1/' | paste -sd+ - | sed 's/^$/0/')
if grep -aq '^emulated Linux: all well' "$1/log"; then
    echo "psl-qemu: $(($passed)) passed, 0 failed"
else
    tail -n 20 "$1/log"
    echo "psl-qemu: $(($passed)) passed, 1 failed"
    exit 1
fi
