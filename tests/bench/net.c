// SPDX-License-Identifier: Apache-2.0
// Measures the processor time of 10 messages in 1 ms over the loopback interface, of which 5 are sent and 5 received.  A run does not sleep.
// Two rows exchange the same bytes: `runtime` by the tasks of net.h, `calls` by the system calls alone (sendto for each message, recvfrom until
// none is left).  Each row receives its own messages.
//     net KIND TICKS; prints nanoseconds per tick.
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>

#include "traffic.h"
#include "traffic_in_net.h"
#include "traffic_out_net.h"
#include "traffic.h"

enum { CHANNELS = 5, BYTES = 60 };

static double processor_ns(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

// ---- the runtime ----

static void run_runtime(uint64_t ticks)
{
    for (uint64_t i = 1; i <= ticks; i++) {
        const SmTick tick = {i * 1000000, i};
        if (sm_receive_step(&traffic_in_receive, &tick) != SM_OK || sm_send_step(&traffic_out_send, &tick) != SM_OK)
            exit(4);
    }
}

// ---- the calls alone ----

static int out[CHANNELS], in[CHANNELS];
static struct sockaddr_in to[CHANNELS];

static void open_sockets(void)
{
    for (int i = 0; i < CHANNELS; i++) {
        memset(&to[i], 0, sizeof to[i]);
        to[i].sin_family = AF_INET;
        to[i].sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        to[i].sin_port = htons((uint16_t)(47201 + i));
        out[i] = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0);
        in[i] = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0);
        if (bind(in[i], (struct sockaddr *)&to[i], sizeof to[i]) != 0)
            exit(5);
    }
}

static uint64_t run_calls(uint64_t ticks)
{
    static char bytes[BYTES + 1];
    uint64_t received = 0;

    for (uint64_t k = 0; k < ticks; k++) {
        for (int i = 0; i < CHANNELS; i++)
            while (recvfrom(in[i], bytes, sizeof bytes, 0, NULL, NULL) > 0)
                received++;
        for (int i = 0; i < CHANNELS; i++)
            sendto(out[i], bytes, BYTES, 0, (struct sockaddr *)&to[i], sizeof to[i]);
    }
    return received;
}

int main(int n, char **argument)
{
    const uint64_t ticks = n > 2 ? strtoull(argument[2], NULL, 10) : 10000;
    const bool is_runtime = n > 1 && strcmp(argument[1], "runtime") == 0;
    uint64_t received = 0;
    double from;

    if (is_runtime && (sm_statevec_init(&traffic_vector) != SM_OK || sm_receive_init(&traffic_in_receive) != SM_OK || sm_send_init(&traffic_out_send) != SM_OK))
        return 3;
    if (!is_runtime)
        open_sockets();
    from = processor_ns();
    if (is_runtime)
        run_runtime(ticks);
    else
        received = run_calls(ticks);
    printf("%.0f\n", (processor_ns() - from) / (double)ticks);
    for (int i = 0; is_runtime && i < CHANNELS; i++)
        received += traffic_in_receive.channel[i].count[SM_NET_accepted];
    return received == CHANNELS * (ticks - 1) && (!is_runtime || traffic_in_receive.channel[0].message.size == BYTES) ? 0 : 6;
}
