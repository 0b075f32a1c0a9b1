// SPDX-License-Identifier: Apache-2.0
// Hosts that swap machines of an application over the link: clauses 12.35 to 12.47 of docs/swapping.md.  The host of smc is connected to the
// application by a simulated line, which loses, repeats and cuts off what a test selects.  Every tick of the application must step the machine.
#include <stdlib.h>
#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/swap/wire.h"
#include "tests/test.h"

// Checks that `one` has stepped at every tick: its count is the number of steps.
static bool has_one_stepped(void) { return stage_number(AT_OUT) == wire.steps; }

// ---- a swap ----

static void test_swap(Arena *arena)
{
    LinkHost h;
    ApplicationInfo info;
    ApplicationMachine m;
    ApplicationSwap s;
    ApplicationItem item;
    Buf swap;

    // clause 12.35: the host needs no compiler, only an image; clause 12.38
    begin(&h);
    CHECK(application_query(&h, &info) && info.protocol == LINK_PROTOCOL && info.machines == 1 && !info.requires_signature);
    CHECK(strcmp(info.name, "stage") == 0 && info.room == SM_SWAP_ROOM(2, STAGE_ROOM));
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE && has_one_stepped());
    stage_settle();
    // clause 12.42
    CHECK(application_read_swap(&h, &s) && s.phase == SM_SWAP_TRIAL && s.machine == UINT16_MAX && s.checksum != 0);
    CHECK(application_read_machine(&h, 0, &m) && m.can_swap && m.is_on_trial && m.checksum == stage_identity(&ten));
    CHECK(strcmp(m.name, "a") == 0 && strcmp(m.state_name, "A") == 0 && m.state == 1);
    CHECK(!application_read_machine(&h, 1, &m) && h.result == SM_E_MISSING);
    CHECK(application_read_item(&h, 0, 0, &item) && item.kind == SMVM_SWAP_STATE && item.fate == SMVM_SWAP_KEPT && strcmp(item.name, "A") == 0);
    CHECK(application_read_item(&h, 0, 1, &item) && item.kind == SMVM_SWAP_LOCAL && strcmp(item.name, "n") == 0);
    CHECK(!application_read_item(&h, 0, 2, &item) && h.result == SM_E_MISSING);
    // clause 12.40: a trial; clause 12.41
    CHECK(send_swap(&h, &swap, NULL, 0, 6) == APPLICATION_BEGIN && h.result == SM_E_BUSY);
    s.checksum++;
    CHECK(!application_confirm(&h, &s, NULL) && h.result == SM_E_HANDLE && stage_phase() == SM_SWAP_TRIAL);
    s.checksum--;
    CHECK(application_confirm(&h, &s, NULL) && stage_phase() == SM_SWAP_CONFIRMED);
    CHECK(application_confirm(&h, &s, NULL));              // clause 12.39
    run_application();
    // a swap to the same image
    CHECK(send_swap(&h, &swap, NULL, 0, 7) == APPLICATION_DONE);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_events(SM_EVENT_SWAP, NULL) == 2);
    // a swap that the application itself has begun
    CHECK(sm_swap_confirm(&stage.swaps) == SM_OK);
    run_application();
    CHECK(stage_swap("a", &one, SM_SWAP_CONTINUE, NULL) == SM_OK);
    stage_settle();
    CHECK(application_read_swap(&h, &s) && s.checksum == 0 && s.phase == SM_SWAP_TRIAL && !application_confirm(&h, &s, NULL) && h.result == SM_E_HANDLE);
}

static void test_refusals(Arena *arena)
{
    LinkHost h;
    ApplicationSwap s;
    Buf swap;

    begin(&h);
    make_swap(&swap, arena, &ten, &b_ten, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_END && h.result == SM_E_ARGUMENT);  // the swap names more machines than the application has
    make_swap(&swap, arena, &ten, NULL, 3, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 6) == APPLICATION_DONE && application_read_swap(&h, &s));
    CHECK(s.phase == SM_SWAP_REFUSED && s.reason == SM_SWAP_NO_MODE && s.machine == 0);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    stage_arm(true);
    CHECK(send_swap(&h, &swap, NULL, 0, 7) == APPLICATION_DONE);
    stage_settle();
    CHECK(application_read_swap(&h, &s) && s.phase == SM_SWAP_REFUSED && s.reason == SM_SWAP_NO_ARMED);
    // both machines, or none
    sim_reset();
    connect_host(&h);
    begin_with(&b_one, NULL);
    make_swap(&swap, arena, &ten, &b_ten, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_events(SM_EVENT_SWAP, NULL) == 2);
}

// ---- the form of a transfer ----

static bool request_begin(LinkHost *h, uint32_t length, uint32_t checksum, uint16_t session)
{
    uint8_t body[9];

    sm_link_store(body, session, 2);
    sm_link_store(body + 2, length, 3);
    sm_link_store(body + 5, checksum, 4);
    return link_request(h, LINK_BEGIN, body, sizeof body) && h->result == SM_OK;
}

static bool request_data(LinkHost *h, uint32_t at, const char *bytes, uint32_t n, uint16_t session)
{
    uint8_t body[LINK_BODY_MAX];

    sm_link_store(body, session, 2);
    sm_link_store(body + 2, at, 3);
    memcpy(body + 5, bytes, n);
    return link_request(h, LINK_DATA, body, 5 + n) && h->result == SM_OK;
}

static SmResult request_end(LinkHost *h, uint16_t session)
{
    uint8_t body[2];

    sm_link_store(body, session, 2);
    return link_request(h, LINK_END, body, sizeof body) ? h->result : SM_E_TIMEOUT;
}

// clause 12.38: wrong positions and lengths
static void test_lies(Arena *arena)
{
    LinkHost h;
    Buf swap;
    uint32_t checksum;

    begin(&h);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    checksum = application_swap_checksum(&swap);
    CHECK(!request_begin(&h, stage.link.room + 1, checksum, 5) && h.result == SM_E_SPACE);
    CHECK(!request_begin(&h, 0, checksum, 5) && h.result == SM_E_ARGUMENT && !request_begin(&h, 1, checksum, 0) && h.result == SM_E_ARGUMENT);
    CHECK(request_begin(&h, 100, checksum, 5));
    CHECK(!request_data(&h, 1, swap.at, 50, 5) && h.result == SM_E_ARGUMENT && sm_link_load(h.body, 3) == 0);
    CHECK(request_data(&h, 0, swap.at, 50, 5) && sm_link_load(h.body, 3) == 50);
    CHECK(request_data(&h, 10, swap.at + 10, 40, 5) && !request_data(&h, 10, swap.at + 11, 40, 5) && !request_data(&h, 10, swap.at + 10, 41, 5));
    CHECK(!request_data(&h, 50, swap.at + 50, 51, 5) && !request_data(&h, 101, swap.at, 1, 5) && stage.link.received == 50);
    CHECK(stage.link.buffer[50] == 0xa5 && request_end(&h, 5) == SM_E_ARGUMENT && request_end(&h, 6) == SM_E_HANDLE);
    CHECK(request_data(&h, 50, swap.at + 50, 50, 5) && request_end(&h, 5) == SM_E_IMAGE && stage.link.buffer[100] == 0xa5);
    CHECK(request_end(&h, 5) == SM_E_HANDLE && stage_phase() == SM_SWAP_IDLE);
    // an END before the last byte: the rest of the buffer contains an earlier transfer
    memcpy(stage.link.buffer, swap.at, swap.n);
    CHECK(request_begin(&h, (uint32_t)swap.n, checksum, 7) && request_data(&h, 0, swap.at, 50, 7) && request_end(&h, 7) == SM_E_ARGUMENT);
}

// Sends bytes as a swap.  Returns the result of END.
static SmResult send_bytes(LinkHost *h, const char *bytes, size_t n)
{
    Buf swap;

    buf_init(&swap, &one.session.arena);
    buf_put(&swap, bytes, n);
    return send_swap(h, &swap, NULL, 0, 5) == APPLICATION_DONE ? SM_OK : h->result;
}

// clause 12.38: every prefix of a swap, a swap with one byte more, and names that end with no zero or with two
static void test_forms(Arena *arena)
{
    LinkHost h;
    Buf swap;

    begin(&h);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    buf_char(&swap, 'x');
    for (size_t n = 1; n <= swap.n; n++)
        CHECK(n == swap.n - 1 || send_bytes(&h, swap.at, n) == SM_E_ARGUMENT);
    swap.n--;
    // version, number of changes, mode, length of the name, name, zero, length of the state
    CHECK(swap.at[3] == 2 && swap.at[4] == 'a' && swap.at[5] == '\0' && swap.at[6] == 0);
    swap.at[5] = 'b';
    CHECK(send_bytes(&h, swap.at, swap.n) == SM_E_ARGUMENT);
    swap.at[5] = swap.at[4] = '\0';
    CHECK(send_bytes(&h, swap.at, swap.n) == SM_E_ARGUMENT);
    swap.at[4] = 'a';
    swap.at[0] = 2;
    CHECK(send_bytes(&h, swap.at, swap.n) == SM_E_ARGUMENT && stage_status().number == 0);
    swap.at[0] = 1;
    CHECK(send_bytes(&h, swap.at, swap.n) == SM_OK);
}

// ---- faults of the line ----

// clause 12.38: the line is cut off after each byte.  The old machine steps at every tick, unless END has arrived.
static void test_cuts(Arena *arena)
{
    LinkHost h;
    Buf swap;
    uint32_t all, begun = 0;

    begin(&h);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE);
    all = wire.sent;
    CHECK(all > swap.n);
    for (uint32_t cut = 0; cut < all; cut++) {
        begin(&h);
        wire.cut = cut;
        CHECK(send_swap(&h, &swap, NULL, 0, 5) != APPLICATION_DONE && h.gone);
        for (int i = 0; i < 10; i++)
            run_application();
        begun += stage_phase() != SM_SWAP_IDLE;
        CHECK(stage_phase() == SM_SWAP_IDLE && has_one_stepped() && stage_events(SM_EVENT_SWAP, NULL) == 0);
    }
    CHECK(begun == 0 && all > 250);
}

// clause 12.39: each frame is lost, each answer is lost, each frame arrives twice.  One swap follows.
static void test_lost_and_repeated(Arena *arena)
{
    LinkHost h;
    Buf swap;
    uint32_t frames;

    begin(&h);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE);
    frames = wire.frames;
    CHECK(frames >= 5);
    for (uint32_t i = 0; i < 3 * frames; i++) {
        begin(&h);
        *(i % 3 == 0 ? &wire.lose : i % 3 == 1 ? &wire.lose_answer : &wire.repeat) = i / 3;
        CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE);
        stage_settle();
        CHECK(stage_phase() == SM_SWAP_TRIAL && stage_events(SM_EVENT_SWAP, NULL) == 1 && stage_status().number == 1);
    }
}

// clause 12.34: refused requests are in the events, each result at most once a second; a repeated request adds none
static void test_refused_requests(Arena *arena)
{
    LinkHost h;
    ApplicationSwap s;
    SmEvent e;
    Buf swap;

    begin(&h);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE);
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL && stage_events(SM_EVENT_HOST_REFUSED, NULL) == 0);
    for (uint16_t session = 6; session < 20; session++)
        CHECK(send_swap(&h, &swap, NULL, 0, session) == APPLICATION_BEGIN && h.result == SM_E_BUSY);
    CHECK(stage_events(SM_EVENT_HOST_REFUSED, &e) == 1 && e.a == (uint32_t)-SM_E_BUSY && e.b == application_swap_checksum(&swap) && e.source == 0);
    CHECK(application_read_swap(&h, &s));
    s.checksum ^= 1;
    CHECK(!application_confirm(&h, &s, NULL) && h.result == SM_E_HANDLE);
    CHECK(stage_events(SM_EVENT_HOST_REFUSED, &e) == 2 && e.a == (uint32_t)-SM_E_HANDLE && e.b == s.checksum);
    (void)pal_clock_sleep_until(pal_clock_now() + PAL_SECOND);
    CHECK(send_swap(&h, &swap, NULL, 0, 20) == APPLICATION_BEGIN && h.result == SM_E_BUSY);
    CHECK(stage_events(SM_EVENT_HOST_REFUSED, NULL) == 3);
}

// clauses 12.50, 12.51: CONFIRM is answered when the swap is stored, and refused if storing fails; a swap without an image returns to the
// built-in machine
static void test_stored(Arena *arena)
{
    const ApplicationChange back = {"a", SM_SWAP_CONTINUE, NULL, NULL, 0};
    const StagePlan plan = {.a = &one, .room = STAGE_ROOM, .trial = 100000};
    ApplicationMachine m;
    ApplicationSwap s;
    LinkHost h;
    Buf swap;

    sim_reset();
    connect_host(&h);
    stage_set_up(&plan);
    stage_reach(SM_SWAP_AT_ADDRESS, "", NULL);
    stage_store("eeprom", 400, NULL);
    CHECK(stage_start() == SM_OK);
    run_application();
    CHECK(application_read_machine(&h, 0, &m) && m.is_built_in && !m.is_stored);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    CHECK(send_swap(&h, &swap, NULL, 0, 5) == APPLICATION_DONE);
    stage_settle();
    CHECK(application_read_swap(&h, &s));
    sim_fail(SIM_nvm_write, 1, SM_E_SPACE);
    CHECK(!application_confirm(&h, &s, NULL) && h.result == SM_E_DEVICE && stage_phase() == SM_SWAP_TRIAL);
    CHECK(application_confirm(&h, &s, NULL) && stage_phase() == SM_SWAP_CONFIRMED && application_confirm(&h, &s, NULL));
    CHECK(application_read_machine(&h, 0, &m) && !m.is_built_in && m.is_stored && m.checksum == stage_identity(&ten));
    run_application();
    buf_init(&swap, arena);
    application_write_swap(&back, 1, NULL, 0, &swap);
    CHECK(send_swap(&h, &swap, NULL, 0, 6) == APPLICATION_DONE);
    stage_settle();
    CHECK(application_read_machine(&h, 0, &m) && m.is_built_in && m.is_on_trial && m.checksum == stage_identity(&one));
    CHECK(application_read_swap(&h, &s) && application_confirm(&h, &s, NULL));
    sm_swap_link_close(&stage.link.service);
    // a storage that does not open: its place becomes free again
    sim_reset();
    memset(sim_nvm("eeprom"), 'x', 64);
    for (int i = 0; i < 2; i++) {
        stage_set_up(&plan);
        stage_reach(SM_SWAP_AT_ADDRESS, "", NULL);
        stage_store("eeprom", 400, NULL);
        CHECK(stage_start() == SM_E_FOREIGN && stage.app.failed_file == stage.store.memory);
    }
}

// clause 12.37: a second host
static void test_two_hosts(Arena *arena)
{
    LinkHost h;
    Buf swap;
    const uint32_t sessions[] = {5, 6};
    uint8_t body[9];

    begin(&h);
    make_swap(&swap, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    sm_link_store(body, sessions[1], 2);
    sm_link_store(body + 2, (uint32_t)swap.n, 3);
    sm_link_store(body + 5, 1, 4);
    CHECK(link_request(&h, LINK_BEGIN, body, sizeof body) && h.result == SM_OK);
    CHECK(send_swap(&h, &swap, NULL, 0, (uint16_t)sessions[0]) == APPLICATION_BEGIN && h.result == SM_E_BUSY);
    (void)pal_clock_sleep_until(pal_clock_now() + 4 * (uint64_t)PAL_SECOND);
    CHECK(send_swap(&h, &swap, NULL, 0, (uint16_t)sessions[0]) == APPLICATION_DONE);
    CHECK(link_request(&h, LINK_END, body, 2) && h.result == SM_E_HANDLE);
    // a damaged swap: its checksum differs
    begin(&h);
    body[0] = 9;
    CHECK(link_request(&h, LINK_BEGIN, body, sizeof body) && h.result == SM_OK);
    for (uint32_t at = 0; at < swap.n; at += 100) {
        const uint32_t n = swap.n - at < 100 ? (uint32_t)swap.n - at : 100;
        uint8_t data[105] = {9};
        sm_link_store(data + 2, at, 3);
        memcpy(data + 5, swap.at + at, n);
        CHECK(link_request(&h, LINK_DATA, data, 5 + n) && h.result == SM_OK);
    }
    CHECK(link_request(&h, LINK_END, body, 2) && h.result == SM_E_IMAGE && stage_phase() == SM_SWAP_IDLE);
}

// ---- hostile hosts ----

static uint32_t seed = 1;

static uint32_t next_random(uint32_t below)
{
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % below;
}

// Makes a frame of a known message with a random body, or with wrong lengths in its fields.  Returns its size.
static uint16_t random_request(uint8_t *request, const Buf *swap)
{
    static const uint8_t messages[] = {LINK_APP, LINK_MACHINE, LINK_SWAP, LINK_KEPT, LINK_BEGIN, LINK_DATA, LINK_END, LINK_CONFIRM, LINK_EVENTS, LINK_READ};
    uint16_t n = (uint16_t)(LINK_HEAD + next_random(LINK_BODY_MAX + 1));

    for (uint16_t i = 0; i < n; i++)
        request[i] = (uint8_t)next_random(256);
    request[1] = next_random(20) ? messages[next_random(sizeof messages)] : (uint8_t)next_random(256);
    if (next_random(3) == 0)
        return n;
    sm_link_store(request + 2, 1 + next_random(2), 2);
    if (request[1] == LINK_BEGIN) {
        sm_link_store(request + 4, (uint32_t)swap->n, 3);
        sm_link_store(request + 7, sm_link_crc((const uint8_t *)swap->at, (uint16_t)swap->n), 4);
    } else if (request[1] == LINK_DATA) {
        const uint32_t at = next_random(3) ? stage.link.received : next_random((uint32_t)swap->n);
        const uint32_t size = swap->n - at < LINK_BODY_MAX - 5 ? (uint32_t)swap->n - at : LINK_BODY_MAX - 5;
        sm_link_store(request + 4, at, 3);
        memcpy(request + 7, swap->at + at, size);
        n = (uint16_t)(LINK_HEAD + 5 + size);
    }
    return n;
}

// Damages a swap: changes a bit, or cuts its end.  The checksum is computed afterwards, so that the application parses the damaged bytes.
static void damage(Buf *swap)
{
    if (next_random(2))
        swap->at[next_random((uint32_t)swap->n)] ^= (char)(1u << next_random(8));
    if (next_random(4) == 0)
        swap->at[next_random(swap->n < 40 ? (uint32_t)swap->n : 40)] = (char)next_random(256);
    if (next_random(3) == 0)
        swap->n = 1 + next_random((uint32_t)swap->n);
}

// clause 12.36: whatever bytes arrive, every tick steps the machine, and the memory around the buffer does not change
static void test_hostile(Arena *arena, unsigned rounds)
{
    unsigned answered = 0, begun = 0, exchanged = 0;
    LinkHost h;
    Buf good;

    make_swap(&good, arena, &ten, NULL, SM_SWAP_CONTINUE, NULL, 0);
    begin(&h);
    for (unsigned i = 0; i < rounds; i++) {
        uint8_t request[LINK_HEAD + LINK_BODY_MAX], answer[LINK_ROOM(LINK_BODY_MAX)];
        Buf bad;
        const double before = stage_number(AT_OUT);
        if (next_random(50) == 0) {                        // a whole transfer of damaged bytes
            buf_init(&bad, arena);
            buf_put(&bad, good.at, good.n);
            if (next_random(4))
                damage(&bad);
            begun += send_swap(&h, &bad, NULL, 0, (uint16_t)(10 + i % 1000)) == APPLICATION_DONE;
            wire.first = wire.end = 0;
            continue;
        }
        answered += sm_swap_link_answer(&stage.link, request, random_request(request, &good), answer) > 0;
        run_application();
        CHECK(stage_number(AT_OUT) == before + 1 || stage_number(AT_OUT) == before + 10);
        if (stage_phase() == SM_SWAP_TRIAL) {
            exchanged++;
            CHECK(sm_swap_confirm(&stage.swaps) == SM_OK);
        }
        (void)pal_clock_sleep_until(pal_clock_now() + next_random(2) * 1000 * (uint64_t)PAL_MILLISECOND);
    }
    CHECK(answered > rounds / 2 && begun > 0 && exchanged > 0);
    (void)pal_clock_sleep_until(pal_clock_now() + 4 * (uint64_t)PAL_SECOND);
    for (int i = 0; i < 20; i++)
        run_application();
    CHECK(stage_phase() != SM_SWAP_TRIAL || sm_swap_confirm(&stage.swaps) == SM_OK);
    run_application();
    CHECK(send_swap(&h, &good, NULL, 0, 3) == APPLICATION_DONE);        // afterwards a valid swap succeeds
    stage_settle();
    CHECK(stage_phase() == SM_SWAP_TRIAL);
}

// ---- connections ----

static void serve(void) { sm_swap_link_serve(&stage.link.service, PAL_MILLISECOND); }

static PalSocket connect_stream(void)
{
    const PalAddress at = {{127, 0, 0, 1}, 4711};
    PalSocket s = {0};

    CHECK(pal_socket_connect(&s, &at, 0) == SM_OK);
    return s;
}

// Sends a request for the properties.  Returns whether the application answers it when it serves its hosts.
static bool ask(PalSocket s)
{
    uint8_t frame[LINK_ROOM(0)] = {0, 3, LINK_APP}, answer[64];
    const uint16_t n = sm_link_encode(frame, LINK_HEAD);
    size_t done;

    CHECK(pal_socket_send(s, frame, n, &done, 0) == SM_OK);
    serve();
    return pal_socket_receive(s, answer, sizeof answer, &done, 0) == SM_OK && done > 0 && answer[done - 1] == 0;
}

// clause 12.37: four connections are served, a fifth waits, silent ones are closed
static void test_connections(void)
{
    PalSocket s[5];
    LinkHost h;
    uint8_t byte = 'x';
    size_t done;

    begin(&h);
    CHECK(sm_swap_link_open(&stage.link.service, &stage.app) == SM_OK);
    for (int i = 0; i < 4; i++) {
        s[i] = connect_stream();
        CHECK(ask(s[i]));
    }
    s[4] = connect_stream();
    CHECK(!ask(s[4]));
    CHECK(ask(s[0]));
    for (int i = 0; i < 11; i++) {                         // a slow sender: one byte at a time, and never a whole frame
        (void)pal_clock_sleep_until(pal_clock_now() + PAL_SECOND);
        CHECK(pal_socket_send(s[1], &byte, 1, &done, 0) == SM_OK || i == 10);
        (void)ask(s[0]);
    }
    CHECK(pal_socket_receive(s[1], &byte, 1, &done, 0) == SM_E_CLOSED && pal_socket_receive(s[2], &byte, 1, &done, 0) == SM_E_CLOSED);
    CHECK(ask(s[0]));
    serve();
    CHECK(pal_socket_receive(s[4], &byte, 1, &done, 0) == SM_OK);        // the fifth was answered
    // clause 12.43: a host that disappears
    CHECK(pal_socket_close(s[0]) == SM_OK && pal_socket_close(s[4]) == SM_OK);
    serve();
    for (int i = 0; i < SM_SWAP_CLIENTS; i++)
        CHECK(!stage.link.client[i].is_open || i > 1);
    sm_swap_link_close(&stage.link.service);
}

int main(int argc, char **argv)
{
    const unsigned rounds = argc > 1 ? (unsigned)strtoul(argv[1], NULL, 10) : 4000;
    Arena *arena;

    machine_compile(&one, COUNT(1), STAGE_SV, 2, true);
    machine_compile(&ten, COUNT(10), STAGE_SV, 2, true);
    machine_compile(&b_one, COUNT_B(1), STAGE_SV, 2, true);
    machine_compile(&b_ten, COUNT_B(10), STAGE_SV, 2, true);
    arena = &one.session.arena;
    test_swap(arena);
    test_refusals(arena);
    test_lies(arena);
    test_forms(arena);
    test_cuts(arena);
    test_lost_and_repeated(arena);
    test_refused_requests(arena);
    test_stored(arena);
    test_two_hosts(arena);
    test_keys(arena);
    test_hostile(arena, rounds);
    test_connections();
    machine_free(&one);
    machine_free(&ten);
    machine_free(&b_one);
    machine_free(&b_ten);
    return test_end("swap/link");
}
