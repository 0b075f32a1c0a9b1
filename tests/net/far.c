// SPDX-License-Identifier: Apache-2.0
// A computer that has no part of smc except the C header of the dictionary.  It reads a line of bytes, and prints the telemetry in them to
// standard output and the bytes of a command to standard error.
#include <stdio.h>

#include "link.h"

int main(void)
{
    smc_commands c = {.run = 1, .number = 0, .v_vent = 0, .v_throttle = 0.25f, .v_trim = -7, .v_target = 1e6, .v_total = UINT64_MAX};
    uint8_t at[256];
    size_t n = 0;
    unsigned byte;
    smc_telemetry t;

    while (n < sizeof at && scanf("%2x", &byte) == 1)
        at[n++] = (uint8_t)byte;
    printf("cause %d", smc_telemetry_decode(at, n, &t));
    printf(": %g %g %u %d %lld %u\n", t.v_pressure, t.v_flow, t.v_open, t.v_tiny, (long long)t.v_wide, t.v_level);
    at[20] ^= 1;
    printf("damaged %d, short %d\n", smc_telemetry_decode(at, n, &t) == SMC_DAMAGED, smc_telemetry_decode(at, n - 1, &t) == SMC_SHORT);
    smc_commands_encode(&c, at);
    for (n = 0; n < smc_commands_BYTES; n++)
        fprintf(stderr, "%02x", at[n]);
    fprintf(stderr, "\n");
    return 0;
}
