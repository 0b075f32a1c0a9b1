// SPDX-License-Identifier: Apache-2.0
// The constants of the VI that the suite uses on sbRIO, in the form in which NI's generator writes them.  No such VI exists: bench_sbrio.c
// simulates its registers.
#ifndef NIFPGA_SUITE_H
#define NIFPGA_SUITE_H

#include "NiFpga.h"

#define NiFpga_Suite_Bitfile "NiFpga_Suite.lvbitx"
static const char *const NiFpga_Suite_Signature = "FFEEDDCCBBAA99887766554433221100";

// For each type: a control, and an indicator that has the same value.
#define SUITE_PAIR(type, n) enum { NiFpga_Suite_Control##type##_Out = 0x18000 + 8 * n, NiFpga_Suite_Indicator##type##_In = 0x18004 + 8 * n };
SUITE_PAIR(Bool, 0)
SUITE_PAIR(I8, 1)
SUITE_PAIR(U8, 2)
SUITE_PAIR(I16, 3)
SUITE_PAIR(U16, 4)
SUITE_PAIR(I32, 5)
SUITE_PAIR(U32, 6)
SUITE_PAIR(I64, 7)
SUITE_PAIR(U64, 8)
SUITE_PAIR(Sgl, 9)
SUITE_PAIR(Dbl, 10)
#undef SUITE_PAIR

// More indicators, which no control sets.
enum { NiFpga_Suite_IndicatorBool_Up = 0x18100, NiFpga_Suite_IndicatorBool_Down = 0x18104 };

#endif
