// SPDX-License-Identifier: Apache-2.0
// A bad network for streams: a relay that passes bytes in pieces of any size, and ends every connection after some time.  It damages a piece of
// every second connection, and cuts the others anywhere, also inside a message.  It prints a line for each.  The same seed makes the same
// choices.
//         relay_stream FROM_PORT TO_PORT SEED
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <poll.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

static uint64_t state;

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

static struct sockaddr_in local(const char *port)
{
    struct sockaddr_in a;

    memset(&a, 0, sizeof a);
    a.sin_family = AF_INET;
    a.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    a.sin_port = htons((uint16_t)atoi(port));
    return a;
}

// Passes the bytes from `in` to `out` until one side ends or the time `end` is reached.  Then it damages a piece, after which the receiver must
// close the connection, or it cuts the connection inside a piece.
static void relay(int in, int out, int64_t end, bool damages)
{
    uint8_t at[512];
    bool over = false, damaged = false;

    while (!over) {
        struct pollfd p = {in, POLLIN, 0};
        ssize_t got = poll(&p, 1, 1000) > 0 ? recv(in, at, 2 + below(sizeof at - 1), 0) : 0;
        const bool is_last = now_ms() >= end;
        if (is_last && damages && !damaged && got > 0) {
            at[below((size_t)got)] ^= (uint8_t)(1u << below(8));
            damaged = true;
            printf("damaged\n");
        } else if (is_last && !damages) {
            got /= 2;
        }
        over = got <= 0 || send(out, at, (size_t)got, MSG_NOSIGNAL) <= 0 || (is_last && !damages) || now_ms() > end + 2000;
    }
    printf("cut\n");
    fflush(stdout);
}

int main(int n, char **argument)
{
    struct sockaddr_in from, to;
    const int on = 1;
    int listening;

    if (n < 4)
        return 3;
    from = local(argument[1]);
    to = local(argument[2]);
    state = strtoull(argument[3], NULL, 10) * 2654435769u + 1;
    listening = socket(AF_INET, SOCK_STREAM, 0);
    setsockopt(listening, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (bind(listening, (struct sockaddr *)&from, sizeof from) != 0 || listen(listening, 4) != 0)
        return 3;
    for (int i = 0;; i++) {
        const int in = accept(listening, NULL, NULL), out = socket(AF_INET, SOCK_STREAM, 0);
        if (in >= 0 && connect(out, (struct sockaddr *)&to, sizeof to) == 0)
            relay(in, out, now_ms() + 200 + (int64_t)below(300), i % 2 == 1);
        close(in);
        close(out);
    }
}
