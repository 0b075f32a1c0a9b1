// SPDX-License-Identifier: Apache-2.0
// Swaps with keys: permits and signatures, the numbers of swaps, and the memory that stores them (clauses 12.39, 12.46 and 12.47).
#include <stdlib.h>
#include <string.h>

#include "runtime-c/psl/sim/sim.h"
#include "tests/swap/wire.h"
#define TEST_PART
#include "tests/test.h"

static uint8_t key[16], wrong[16];         // the bytes of right_key and wrong_key

static void read_key(const char *digits, uint8_t *into)
{
    for (int i = 0; i < 16; i++) {
        const char two[] = {digits[2 * i], digits[2 * i + 1], '\0'};
        into[i] = (uint8_t)strtoul(two, NULL, 16);
    }
}

static void begin_with_key(LinkHost *h, bool fresh)
{
    if (fresh) {
        sim_reset();
        memcpy(sim_nvm("flash"), right_key, 32);
    }
    connect_host(h);
    begin_with(NULL, "flash");
}

static void end_with_key(void) { sm_swap_link_close(&stage.link.service); }

// clause 12.46: no permit, a permit of another key, and a swap that was changed after it was signed; then CONFIRM
static void test_signatures(Arena *arena)
{
    LinkHost h;
    ApplicationSwap s;
    SmEvent e;
    Buf swap, plain;

    begin_with_key(&h, true);
    make_swap(&plain, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &plain, NULL, 0, 5) == APPLICATION_BEGIN && h.result == SM_E_UNSIGNED);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, wrong, 1);
    CHECK(send_swap(&h, &swap, wrong, 1, 5) == APPLICATION_BEGIN && h.result == SM_E_UNSIGNED);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, key, 3);
    for (size_t i = 0; i < swap.n; i += 13) {
        swap.at[i] ^= 1;
        CHECK(send_swap(&h, &swap, key, 3, (uint16_t)(6 + i)) == APPLICATION_END && h.result == SM_E_UNSIGNED);
        swap.at[i] ^= 1;
    }
    CHECK(stage_phase() == SM_SWAP_IDLE && stage.link.newest == 0);
    CHECK(stage_events(SM_EVENT_HOST_REFUSED, &e) == 1 && e.a == (uint32_t)-SM_E_UNSIGNED && e.b == application_swap_checksum(&plain));
    CHECK(send_swap(&h, &swap, key, 3, 6) == APPLICATION_DONE && stage.link.newest == 3);
    stage_settle();
    CHECK(application_read_swap(&h, &s) && s.phase == SM_SWAP_TRIAL && s.number == 3);
    CHECK(!application_confirm(&h, &s, NULL) && h.result == SM_E_UNSIGNED && !application_confirm(&h, &s, wrong) && h.result == SM_E_UNSIGNED);
    CHECK(application_confirm(&h, &s, key) && stage_phase() == SM_SWAP_CONFIRMED);
    run_application();
    end_with_key();
}

// clause 12.47: the same swap again, an older swap, and both after a restart
static void test_replays(Arena *arena)
{
    LinkHost h;
    Buf swap;

    begin_with_key(&h, true);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, key, 3);
    CHECK(send_swap(&h, &swap, key, 3, 6) == APPLICATION_DONE);
    stage_settle();
    CHECK(sm_swap_confirm(&stage.swaps) == SM_OK);
    run_application();
    CHECK(send_swap(&h, &swap, key, 3, 8) == APPLICATION_BEGIN && h.result == SM_E_REPLAY);
    end_with_key();
    begin_with_key(&h, false);
    CHECK(stage.link.newest == 3);
    CHECK(send_swap(&h, &swap, key, 3, 9) == APPLICATION_BEGIN && h.result == SM_E_REPLAY);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, key, 2);
    CHECK(send_swap(&h, &swap, key, 2, 10) == APPLICATION_BEGIN && h.result == SM_E_REPLAY);
    end_with_key();
}

// A permit with a higher number than that of the swap: for a swap that is not signed, and for a swap whose number has been used.
static void test_foreign_permits(Arena *arena)
{
    LinkHost h;
    Buf swap;

    begin_with_key(&h, true);
    make_swap(&swap, arena, &ten, NULL, 3, key, 4);
    CHECK(send_swap(&h, &swap, key, 4, 20) == APPLICATION_DONE && stage.link.newest == 4);
    run_application();
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, wrong, 5);
    CHECK(send_swap(&h, &swap, key, 5, 21) == APPLICATION_END && h.result == SM_E_UNSIGNED && stage.link.newest == 4);
    end_with_key();
    begin_with_key(&h, true);
    make_swap(&swap, arena, &ten, NULL, 3, key, 3);
    CHECK(send_swap(&h, &swap, key, 3, 22) == APPLICATION_DONE && stage.link.newest == 3);
    end_with_key();
    begin_with_key(&h, false);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, key, 2);
    CHECK(send_swap(&h, &swap, key, 4, 11) == APPLICATION_END && h.result == SM_E_REPLAY && stage_phase() == SM_SWAP_IDLE);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, key, 4);
    CHECK(send_swap(&h, &swap, key, 4, 12) == APPLICATION_DONE && stage.link.newest == 4);
    end_with_key();
}

// clause 12.39: END arrives again while the refusal of another swap is not yet in the events
static void test_repeated_end(Arena *arena)
{
    uint32_t frames;
    LinkHost h;
    Buf swap;

    begin_with_key(&h, true);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, key, 1);
    CHECK(send_swap(&h, &swap, key, 1, 5) == APPLICATION_DONE);
    frames = wire.frames;                                  // the last frame is END
    end_with_key();
    begin_with_key(&h, true);
    wire.refuse = frames;
    CHECK(send_swap(&h, &swap, key, 1, 5) == APPLICATION_DONE && wire.ends_busy == 1 && stage.link.newest == 1);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL);
    end_with_key();
}

// The application does not start without its key, or without the memory for the numbers of swaps.
static void test_missing_files(void)
{
    LinkHost h;

    begin_with_key(&h, true);
    end_with_key();
    // no key in the file
    sim_nvm("flash")[31] = 'g';
    CHECK(sm_swap_link_open(&stage.link.service, &stage.app) == SM_E_ARGUMENT && stage.app.failed_file == stage.link.key_file);
    CHECK(stage.app.reason != NULL);
    // no memory for the numbers
    memcpy(sim_nvm("flash"), right_key, 32);
    stage.link.number_memory = "absent";
    CHECK(sm_swap_link_open(&stage.link.service, &stage.app) == SM_E_MISSING && stage.app.failed_file == stage.link.number_memory && stage.app.reason == NULL);
    // no file
    stage.link.key_file = "absent";
    CHECK(sm_swap_link_open(&stage.link.service, &stage.app) == SM_E_MISSING && stage.app.failed_file == stage.link.key_file && stage.app.reason != NULL);
}

// clause 12.47: the power is cut after each byte that writes the number.  After the restart, the highest number is the old or the new one.
static void test_power_cuts(Arena *arena)
{
    uint32_t stored = 0;
    LinkHost h;
    Buf swap;

    for (uint32_t bytes = 0; bytes <= 8; bytes++) {
        begin_with_key(&h, true);
        for (uint32_t number = 1; number <= 3; number++) {
            make_swap(&swap, arena, &ten, NULL, 3, key, number);       // refused for its mode: the next one can follow
            if (number == 3)
                sim_cut_power(0, bytes);
            CHECK((send_swap(&h, &swap, key, number, (uint16_t)(5 + number)) == APPLICATION_DONE) == (number < 3));
            run_application();
        }
        CHECK(stage_status().number == 2);
        sim_power_on();
        CHECK(pal_socket_close(stage.link.listening) == SM_OK);
        begin_with_key(&h, false);
        CHECK(stage.link.newest == 2 || stage.link.newest == 3);
        stored += stage.link.newest == 3;
        end_with_key();
    }
    CHECK(stored > 0);
}

void test_keys(Arena *arena)
{
    read_key(right_key, key);
    read_key(wrong_key, wrong);
    test_signatures(arena);
    test_replays(arena);
    test_foreign_permits(arena);
    test_repeated_end(arena);
    test_missing_files();
    test_power_cuts(arena);
}
