// SPDX-License-Identifier: Apache-2.0
// Vectors of a Cortex-M: stack pointer, start, and faults, whose handlers do not return.
#include <stdint.h>

extern uint32_t stack_top[];
void begin(void);
void trapped(void);
void reset(void);

enum { CCR_UNALIGN_TRP = 1u << 3, CP10_CP11 = 0xfu << 20 };

// A Cortex-M0 cannot read misaligned data, so a larger chip that emulates it is set to trap on it.  An FPU must be enabled.
void reset(void)
{
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xe000ed88 |= CP10_CP11;
    __asm__ volatile("dsb\nisb");
#endif
#if !defined(__ARM_FEATURE_UNALIGNED)
    *(volatile uint32_t *)0xe000ed14 |= CCR_UNALIGN_TRP;
#endif
    begin();
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    stack_top, (const void *)reset, (const void *)trapped, (const void *)trapped, (const void *)trapped, (const void *)trapped, (const void *)trapped,
};
