// SPDX-License-Identifier: Apache-2.0
// Swaps between threads, on Linux: two executors with a machine each, a thread that prepares, one that requests swaps, and a host.  A machine
// computes a sum, so that a step that is lost or runs twice is noticed.  Runs for SECONDS, also under the thread sanitizer.
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/shared.h"
#include "tests/swap/stage.h"
#include "tests/test.h"

// Both machines add to their element; a swap never changes it.
#define COUNT(elements, element, by) elements "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + 1\n" element " = " element " + " #by "\n"

static SwapMachine machine[2][2];
static uint32_t ended;
static unsigned confirmed, returned, both, refused;
static SmSwapStatus last;

static unsigned long draw(void)
{
    static uint64_t seed = 1;

    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (unsigned long)(seed >> 33);
}

static const SwapMachine *other_image(unsigned i) { return &machine[i][draw() & 1]; }

// Begins a swap of one machine, or of both.
static void begin(void)
{
    const SwapMachine *a = other_image(0), *b = other_image(1);
    const uint8_t mode = (uint8_t)(draw() % 4 != 0 ? SM_SWAP_CONTINUE : SM_SWAP_RESTART);
    const SmSwapChange change[] = {{"a", a->image, a->image_size, mode, NULL, false}, {"b", b->image, b->image_size, mode, NULL, false}};
    const unsigned first = (unsigned)(draw() & 1), n = draw() & 1 ? 2 : 1;

    if (sm_swap_begin(&stage.swaps, n == 2 ? change : &change[first], (uint16_t)n) == SM_OK)
        both += n == 2;
}

// The thread that requests swaps: begins them, confirms half of them, and counts their results.
static void *ask(void *argument)
{
    (void)argument;
    while (!sm_shared_read(&ended)) {
        const SmSwapStatus s = stage_status();
        if (s.phase == SM_SWAP_TRIAL && s.number != last.number) {
            last = s;
            if (s.number & 1)
                (void)sm_swap_confirm(&stage.swaps);
        }
        if (s.phase == SM_SWAP_CONFIRMED || s.phase == SM_SWAP_RETURNED || s.phase == SM_SWAP_REFUSED || s.phase == SM_SWAP_IDLE) {
            confirmed += s.phase == SM_SWAP_CONFIRMED;
            returned += s.phase == SM_SWAP_RETURNED;
            refused += s.phase == SM_SWAP_REFUSED;
            begin();
        }
        (void)pal_clock_sleep_until(pal_clock_now() + 100 * PAL_MICROSECOND);
    }
    return NULL;
}

// ---- a host ----

static unsigned answers;

// Sends a request with a body of 6 bytes, and waits for the zero that ends its answer.
static bool request(PalSocket s, LinkMessage message, uint32_t item)
{
    uint8_t frame[LINK_ROOM(6)] = {0, 1, (uint8_t)message, (uint8_t)(item & 1)}, byte = 1;
    size_t n;

    sm_link_store(frame + 5, item / 2 % 4, 4);
    if (pal_socket_send(s, frame, sm_link_encode(frame, LINK_HEAD + 6), &n, PAL_SECOND) != SM_OK)
        return false;
    while (byte != 0)
        if (pal_socket_receive(s, &byte, 1, &n, PAL_SECOND) != SM_OK)
            return false;
    return true;
}

// The thread of a host.  It requests the running machines, the fates of items and the events while machines are swapped.
static void *query(void *argument)
{
    static const LinkMessage messages[] = {LINK_APP, LINK_MACHINE, LINK_SWAP, LINK_KEPT, LINK_EVENTS, LINK_BEGIN};
    PalSocket s;

    (void)argument;
    while (!sm_shared_read(&ended) && pal_socket_connect(&s, &stage.link.address, PAL_SECOND) != SM_OK)
        (void)pal_clock_sleep_until(pal_clock_now() + PAL_MILLISECOND);
    for (uint32_t i = 0; !sm_shared_read(&ended); i++)
        answers += request(s, messages[i % 6], i / 6);
    (void)pal_socket_close(s);
    return NULL;
}

static uint64_t run_time;

static void act(const SmTick *tick)
{
    if (tick->time >= run_time)
        sm_app_stop(&stage.app);
}

int main(int argc, char **argv)
{
    const StagePlan plan = {.a = &machine[0][0], .b = &machine[1][0], .room = STAGE_ROOM, .trial = 30, .two_executors = true, .guarded = true,
                            .period = {200 * PAL_MICROSECOND, 300 * PAL_MICROSECOND}, .act = act};
    pthread_t thread, host;

    run_time = (argc > 1 ? strtoul(argv[1], NULL, 10) : 3) * (uint64_t)PAL_SECOND;
    machine_compile(&machine[0][0], COUNT(A, "out", 1), STAGE_SV, 2, true);
    machine_compile(&machine[0][1], COUNT(A, "out", 1000), STAGE_SV, 2, true);
    machine_compile(&machine[1][0], COUNT(B, "more", 1), STAGE_SV, 2, true);
    machine_compile(&machine[1][1], COUNT(B, "more", 1000), STAGE_SV, 2, true);
    stage_set_up(&plan);
    stage_reach(SM_SWAP_AT_ADDRESS, "", NULL);
    stage.link.address.port = (uint16_t)(40000 + getpid() % 20000);
    CHECK(pthread_create(&thread, NULL, ask, NULL) == 0 && pthread_create(&host, NULL, query, NULL) == 0);
    CHECK(sm_app_run(&stage.app) == SM_OK);
    sm_shared_write(&ended, 1);
    CHECK(pthread_join(thread, NULL) == 0 && pthread_join(host, NULL) == 0);
    fprintf(stderr, "%u swaps confirmed, %u returned, %u refused, %u of both machines; %u answers to a host\n", confirmed, returned, refused, both,
            answers);
    CHECK(answers > 100);
    CHECK(confirmed > 10 && returned > 10 && both > 5 && refused == 0);
    for (int i = 0; i < 2; i++) {
        // Each tick made one step of one image, which added 1 or 1000.  A step is refused if the other executor had a later time.
        const uint64_t sum = (uint64_t)stage_number(i == 0 ? AT_OUT : AT_MORE), steps = stage.executor[i].ticks - stage.machine[i].machine->refused;
        CHECK(steps > 1000 && sum >= steps && (sum - steps) % 999 == 0);
    }
    return test_end("swap/threads");
}
