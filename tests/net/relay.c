// SPDX-License-Identifier: Apache-2.0
// A bad network between two computers: a relay that loses, delays, repeats, reorders, damages, cuts and lengthens datagrams.  The same seed
// makes the same choices.
//     relay FROM_PORT TO_PORT SEED
// With a fourth argument, a number of milliseconds, it instead sends as many packets as the system accepts, for that time.
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>

enum { ROOM = 2048, HELD = 16 };

typedef struct Held { uint8_t at[ROOM]; size_t n; int64_t due; } Held;

static Held held[HELD];
static uint64_t state;
static int in, out;
static struct sockaddr_in to;

static uint64_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static size_t below(size_t n) { return (size_t)(next_random() % n); }

static int64_t now_ms(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

static void pass(const uint8_t *at, size_t n) { (void)!sendto(out, at, n, 0, (struct sockaddr *)&to, sizeof to); }

// Holds a packet for `ms` milliseconds, so that later packets overtake it.  If the table is full, passes it at once.
static void hold(const uint8_t *at, size_t n, int64_t ms)
{
    for (int i = 0; i < HELD; i++)
        if (held[i].n == 0 && n > 0) {
            memcpy(held[i].at, at, n);
            held[i].n = n;
            held[i].due = now_ms() + ms;
            return;
        }
    pass(at, n);
}

static void release(void)
{
    for (int i = 0; i < HELD; i++)
        if (held[i].n && held[i].due <= now_ms()) {
            pass(held[i].at, held[i].n);
            held[i].n = 0;
        }
}

static void treat(uint8_t *at, size_t n)
{
    switch (below(12)) {
    case 0: return;                                                       // lost
    case 1: pass(at, n), pass(at, n); return;                             // repeated
    case 2: hold(at, n, (int64_t)below(30) + 3); return;                  // reordered
    case 3: hold(at, n, (int64_t)below(200) + 100), pass(at, n); return;  // repeated late
    case 4: at[below(n)] ^= (uint8_t)(1u << below(8)); break;             // damaged
    case 5: n = below(n); break;                                          // cut
    case 6: n += below(ROOM - n); break;                                  // lengthened
    default: break;
    }
    pass(at, n);
}

static void flood(int64_t ms)
{
    const int64_t end = now_ms() + ms;
    uint8_t at[ROOM];
    unsigned long packets = 0;

    while (now_ms() < end) {
        for (size_t i = 0; i < 64; i++)
            at[i] = (uint8_t)next_random();
        pass(at, below(100));
        packets++;
    }
    printf("flooded %lu\n", packets);
}

int main(int n, char **argument)
{
    struct sockaddr_in from;

    memset(&from, 0, sizeof from);
    from.sin_family = AF_INET;
    from.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to = from;
    if (n < 4)
        return 3;
    from.sin_port = htons((uint16_t)atoi(argument[1]));
    to.sin_port = htons((uint16_t)atoi(argument[2]));
    state = strtoull(argument[3], NULL, 10) * 2654435769u + 1;
    out = socket(AF_INET, SOCK_DGRAM, 0);
    if (n > 4) {
        flood(atoi(argument[4]));
        return 0;
    }
    in = socket(AF_INET, SOCK_DGRAM, 0);
    if (bind(in, (struct sockaddr *)&from, sizeof from) != 0)
        return 3;
    for (;;) {
        static uint8_t at[ROOM];
        struct pollfd p = {in, POLLIN, 0};
        ssize_t got = poll(&p, 1, 1) > 0 ? recv(in, at, sizeof at, 0) : 0;
        if (got > 0)
            treat(at, (size_t)got);
        release();
    }
}
