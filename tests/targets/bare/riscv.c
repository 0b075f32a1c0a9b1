// SPDX-License-Identifier: Apache-2.0
// QEMU's "virt" starts a program at the first address of its RAM.
__asm__(".section .vectors, \"ax\"\n"
        ".globl _start\n"
        "_start:\n"
        ".option push\n"
        ".option norelax\n"
        ".option arch, +zicsr\n"
        "    la gp, __global_pointer$\n"
        "    la sp, stack_top\n"
        "    la t0, trapped\n"
        "    csrw mtvec, t0\n"
        "    li t0, 0x6000\n"             // mstatus.FS: enables the FPU
        "    csrs mstatus, t0\n"
        "    j begin\n"
        ".option pop\n");
