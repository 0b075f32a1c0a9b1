// SPDX-License-Identifier: Apache-2.0
#include "tests/swap/wire.h"

#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/sim.h"
#define TEST_PART
#include "tests/test.h"

SwapMachine one, ten, b_one, b_ten;
const char right_key[33] = "00112233445566778899aabbccddeeff", wrong_key[33] = "ff112233445566778899aabbccddeeff";

// ---- a line ----

Wire wire;

void run_application(void)
{
    (void)sm_swaps_prepare(&stage.swaps);
    stage_tick(0);
    wire.steps++;
}

static void deliver_frame(bool answers)
{
    uint8_t answer[LINK_ROOM(LINK_BODY_MAX)];
    uint16_t n;

    if (wire.refuse != 0 && wire.frames == wire.refuse)
        CHECK(stage_swap("a", &ten, (SmSwapMode)3, NULL) == SM_OK);
    n = sm_swap_link_answer(&stage.link, wire.in.buffer, wire.in.n, answer);
    wire.ends_busy += n > 0 && wire.in.buffer[1] == LINK_END && stage.link.transfer == SM_SWAP_RECEIVING;
    CHECK(n <= sizeof answer);
    if (answers && wire.end + n <= sizeof wire.answers) {
        memcpy(wire.answers + wire.end, answer, n);
        wire.end += n;
    }
    run_application();
}

static bool wire_send(void *context, const uint8_t *bytes, size_t n)
{
    (void)context;
    for (size_t i = 0; i < n; i++) {
        if (wire.sent == wire.cut)
            return false;
        wire.sent++;
        if (sm_link_receive(&wire.in, bytes[i])) {
            const uint32_t number = wire.frames++;
            if (number == wire.lose)
                continue;
            deliver_frame(number != wire.lose_answer);
            if (number == wire.repeat)
                deliver_frame(true);
        }
    }
    return true;
}

static int wire_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait)
{
    (void)context, (void)room;
    if (wire.first == wire.end) {
        wire.first = wire.end = 0;
        for (uint32_t i = 0; i < (wait < 5 ? wait : 5); i++)
            run_application();
        (void)pal_clock_sleep_until(pal_clock_now() + (uint64_t)wait * PAL_MILLISECOND);
        return 0;
    }
    bytes[0] = wire.answers[wire.first++];
    return 1;
}

static uint32_t wire_now(void *context)
{
    (void)context;
    return (uint32_t)(pal_clock_now() / PAL_MILLISECOND);
}

static const SerialLine line = {NULL, wire_send, wire_receive, wire_now};

void connect_host(LinkHost *h)
{
    memset(&wire, 0, sizeof wire);
    wire.cut = wire.lose = wire.lose_answer = wire.repeat = UINT32_MAX;
    sm_link_receiver_init(&wire.in, wire.received, sizeof wire.received);
    link_host_init(h, &line, 20, 4, 7);
}

// ---- an application ----

void begin_with(const SwapMachine *b, const char *key_file)
{
    const StagePlan plan = {.a = &one, .b = b, .room = STAGE_ROOM, .trial = 100000};

    stage_begin(&plan);
    stage_reach(SM_SWAP_AT_ADDRESS, "", key_file);
    if (key_file != NULL)
        CHECK(sm_swap_link_open(&stage.link.service, &stage.app) == SM_OK);
    run_application();
}

void begin(LinkHost *h)
{
    sim_reset();
    connect_host(h);
    begin_with(NULL, NULL);
    wire.steps = 1;
}

void make_swap(Buf *out, Arena *arena, const SwapMachine *a, const SwapMachine *b, uint8_t mode, const uint8_t *key, uint32_t number)
{
    const ApplicationChange change[] = {{"a", mode, NULL, a->image, a->image_size}, {"b", mode, NULL, b ? b->image : NULL, b ? b->image_size : 0}};

    buf_init(out, arena);
    application_write_swap(change, b ? 2 : 1, key, number, out);
}

ApplicationStep send_swap(LinkHost *h, const Buf *swap, const uint8_t *key, uint32_t number, uint16_t session)
{
    ApplicationInfo info;

    return application_query(h, &info) ? application_send_swap(h, &info, swap, key, number, session) : APPLICATION_BEGIN;
}
