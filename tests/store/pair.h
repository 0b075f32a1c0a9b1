// SPDX-License-Identifier: Apache-2.0
// A simulated board and the host of smc, connected by a line.  The line loses, repeats, delays, cuts and damages one frame in
// Wire.trouble, and the board restarts after Wire.restart received bytes.  What goes wrong is drawn from random_state.
#ifndef TESTS_STORE_PAIR_H
#define TESTS_STORE_PAIR_H

#include "compiler/device/device.h"
#include "tests/store/board.h"
#include "tests/test.h"

enum { QUEUE = 4096 };

static Image old_image, new_image;
static uint64_t random_state;
static inline uint32_t random_below(uint32_t n)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return n ? (uint32_t)(random_state >> 11) % n : 0;
}

// ---- the line ----

typedef struct Way { uint8_t byte[QUEUE]; uint32_t first, n; uint8_t late[LINK_ROOM(LINK_BODY_MAX) + 1]; size_t lates; } Way;

typedef struct Wire {
    Board *board;
    Way to_board, to_host;
    uint32_t now;             // milliseconds
    uint32_t trouble;         // one frame in this many is affected; 0: none
    uint32_t restart;         // the board restarts after this many received bytes; 0: never
    uint32_t taken;           // bytes that the board has received
} Wire;

static inline void put(Way *w, const uint8_t *bytes, size_t n)
{
    for (size_t i = 0; i < n && w->n < QUEUE; i++)
        w->byte[(w->first + w->n++) % QUEUE] = bytes[i];
}

static inline uint8_t take(Way *w)
{
    const uint8_t byte = w->byte[w->first];

    w->first = (w->first + 1) % QUEUE;
    w->n--;
    return byte;
}

static inline void send_noise(Way *w)
{
    for (uint32_t n = random_below(40); n > 0; n--) {
        const uint8_t byte = (uint8_t)random_below(256);
        put(w, &byte, 1);
    }
}

// Carries a frame over a line that can lose, damage or repeat it.
static inline void carry_frame(Way *w, const uint8_t *bytes, size_t n, uint32_t trouble)
{
    uint8_t copy[LINK_ROOM(LINK_BODY_MAX) + 1];

    memcpy(copy, bytes, n);
    switch (trouble && random_below(trouble) == 0 ? 1 + random_below(7) : 0) {
    case 1: break;                                             // lost
    case 2: put(w, copy, n); put(w, copy, n); break;           // twice
    case 3: put(w, copy, random_below((uint32_t)n)); break;           // its end is lost
    case 4: copy[random_below((uint32_t)n)] ^= (uint8_t)(1u << random_below(8)); put(w, copy, n); break;
    case 5: send_noise(w); put(w, copy, n); send_noise(w); break;
    case 6: memcpy(w->late, copy, n); w->lates = n; break;     // after the next one
    case 7: put(w, copy + 1 + random_below((uint32_t)n - 1), 1); put(w, copy, n); break;
    default:
        put(w, copy, n);
        if (w->lates && random_below(2)) {
            put(w, w->late, w->lates);
            w->lates = 0;
        }
    }
}

static inline void board_restarts(Wire *w)
{
    w->to_board.n = 0;
    CHECK(board_start(w->board));
}

// Lets the board process the bytes that have arrived.
static inline void run_board(Wire *w)
{
    while (w->to_board.n > 0) {
        const uint16_t n = board_takes(w->board, take(&w->to_board));
        if (n > 0)
            carry_frame(&w->to_host, w->board->frame, n, w->trouble);
        if (!w->board->up || ++w->taken == w->restart || w->board->agent.restart)
            board_restarts(w);
    }
}

static inline bool wire_send(void *context, const uint8_t *bytes, size_t n)
{
    Wire *w = context;

    carry_frame(&w->to_board, bytes, n, w->trouble);
    return true;
}

static inline int wire_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait)
{
    Wire *w = context;
    size_t n = 0;

    run_board(w);
    while (n < room && w->to_host.n > 0)
        bytes[n++] = take(&w->to_host);
    w->now += n > 0 ? 0 : wait;
    return (int)n;
}

static inline uint32_t wire_now(void *context) { return ((const Wire *)context)->now; }

// ---- a board and a host ----

typedef struct Pair { Board board; Wire wire; SerialLine line; LinkHost host; } Pair;

static inline void connect_pair(Pair *p, const char *memory, uint8_t slots)
{
    memset(p, 0, sizeof *p);
    CHECK(board_new(&p->board, memory, slots));
    p->wire.board = &p->board;
    p->line.context = &p->wire;
    p->line.send = wire_send;
    p->line.receive = wire_receive;
    p->line.now = wire_now;
    link_host_init(&p->host, &p->line, 100, 8, (uint8_t)random_below(256));
}

static inline DeviceStep update_image(Pair *p, const Image *image, Update *u)
{
    DeviceInfo info;

    memset(u, 0, sizeof *u);
    u->bytes = image->bytes;
    u->length = image->length;
    u->checksum = image->checksum;
    u->session = (uint16_t)(1 + random_below(65535));
    return device_query_info(&p->host, &info) ? device_update(&p->host, &info, u) : DEVICE_FIND;
}

static inline bool is_running(const Board *b, const Image *image)
{
    return b->slot != STORE_BUILT_IN && memcmp(b->store.plan.image[b->slot], image->bytes, image->length) == 0;
}

// Prepares a pair whose old image is confirmed and runs.
static inline void prepare_pair(Pair *p, const char *memory, uint8_t slots)
{
    Update u;

    connect_pair(p, memory, slots);
    CHECK(update_image(p, &old_image, &u) == DEVICE_DONE && is_running(&p->board, &old_image));
    CHECK(device_confirm_image(&p->host, old_image.checksum));
}

// Makes the line error-free again.
static inline void repair_line(Pair *p)
{
    memset(&p->wire.to_board, 0, sizeof p->wire.to_board);
    memset(&p->wire.to_host, 0, sizeof p->wire.to_host);
    p->wire.trouble = p->wire.restart = 0;
    p->board.may = p->board.fits = SM_OK;
}

#endif
