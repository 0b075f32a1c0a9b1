// SPDX-License-Identifier: Apache-2.0
// The runtime's side of tests/net/dictionary.sh (clause 11.20).  It sends a telemetry message of tests/runtime/link.net and prints its bytes.
// Then it reads lines of bytes, receives each line as `commands`, and prints the elements and the counts.
#include <stdio.h>

#include "link_net.h"
#include "link.h"
#include "runtime-c/psl/sim/sim.h"

const uint8_t linkKey[SM_NET_KEY] = {1};

static PalSocket other;

static void print_telemetry(void)
{
    const SmTick tick = {0, 0};
    uint8_t bytes[128];
    size_t n = 0;

    link_sv.pressure = 12.75;
    link_sv.flow = -2.5f;
    link_sv.open = 1;
    link_sv.tiny = -3;
    link_sv.wide = -5000000000;
    link_sv.level = 65535;
    if (sm_send_init(&link_send) != SM_OK || sm_send_step(&link_send, &tick) != SM_OK ||
        pal_socket_receive_from(other, NULL, bytes, sizeof bytes, &n, 0) != SM_OK)
        printf("nothing was sent\n");
    for (size_t i = 0; i < n; i++)
        printf("%02x", bytes[i]);
    printf("\n");
}

static void receive_line(const char *line, uint64_t time)
{
    const PalAddress to = {{127, 0, 0, 1}, 5001};
    const SmTick tick = {time, 0};
    uint8_t bytes[128];
    size_t n = 0;
    unsigned byte;

    while (n < sizeof bytes && sscanf(line + 2 * n, "%2x", &byte) == 1)
        bytes[n++] = (uint8_t)byte;
    pal_socket_send_to(other, &to, bytes, n);
    sm_receive_step(&link_receive, &tick);
    printf("%u %g %d %g %llu accepted %u refused %u\n", link_sv.vent, link_sv.throttle, link_sv.trim, link_sv.target,
           (unsigned long long)link_sv.total, link_sv.accepted, link_sv.refused);
}

int main(void)
{
    const PalAddress here = {{10, 0, 0, 2}, 5000};
    char line[512];

    sim_reset();
    if (sm_statevec_init(&link_vector) != SM_OK || pal_socket_udp(&other, &here) != SM_OK || sm_receive_init(&link_receive) != SM_OK)
        return 3;
    print_telemetry();
    for (uint64_t time = 0; fgets(line, sizeof line, stdin); time += 1000000)
        receive_line(line, time);
    return 0;
}
