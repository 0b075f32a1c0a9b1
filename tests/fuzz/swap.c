// SPDX-License-Identifier: Apache-2.0
// Fuzz target: any bytes from hosts to an application whose machines can be swapped: raw bytes, valid frames with any body, and whole swaps with
// changes.  The sanitizers check that no access is outside its memory.  Every answer must be a valid frame, one machine must step at every tick,
// and after a restart the machines run that were confirmed last.
//
// An input: a byte of flags (1: a key, 2: two machines, 4: decoded, 8: nothing is stored), then operations.  Each is a byte with its kind in the
// upper and a host in the lower four bits, a byte n, and n bytes.
#include "tests/fuzz/fuzz.h"

#include <string.h>

#include "bytecode-vm/permit.h"
#include "compiler/device/app_host.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/psl/sim/sim.h"
#include "stdlib/crc32.h"
#include "tests/swap/stage.h"

#define COUNT(by) A "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nout = n\n"
#define COUNT_B(by) B "[local]\nU32 n = 0\n[A] @swap\n.step\nn = n + " #by "\nmore = n\n"

enum { FLAG_KEY = 1, FLAG_TWO = 2, FLAG_DECODED = 4, FLAG_NOT_STORED = 8 };
enum { OP_RAW, OP_FRAME, OP_SWAP, OP_CONFIRM, OP_TICKS, OP_SLEEP, OP_RECONNECT, OP_ARM, OPS };
enum { HOSTS = 5, SWAPS = 5, SWAP_MOST = 1024, TICKS_MOST = 4000 };

static const char digits[] = "00112233445566778899aabbccddeeff";
static SwapMachine one, ten, b_one, b_ten;
static Buf swaps[SWAPS];      // the swaps without a signature
static uint8_t key[SMVM_KEY];

// ---- the application ----

typedef struct Host {
    PalSocket stream;
    bool is_open;
    LinkReceiver in;
    uint8_t received[LINK_ROOM(LINK_BODY_MAX)];
} Host;

static struct {
    StagePlan plan;
    uint8_t flags;
    Host host[HOSTS];
    uint32_t confirmed[2];    // the checksums of the images that run after a restart
    uint32_t number;          // the number of the last signed swap
    uint32_t ticks;
} world;

unsigned long fuzz_reached;           // inputs that bring a swap on trial
const unsigned fuzz_floor = 10;

static uint32_t identity(uint16_t machine)
{
    SmSwapMachineState s;

    memset(&s, 0, sizeof s);
    (void)sm_swap_machine(&stage.swaps, machine, &s);
    return s.identity;
}

static bool start(void)
{
    stage_set_up(&world.plan);
    stage_reach(SM_SWAP_AT_ADDRESS, "", world.flags & FLAG_KEY ? "flash" : NULL);
    stage.link.number_memory = "eeprom";
    if ((world.flags & (FLAG_NOT_STORED | FLAG_KEY)) == 0)        // the simulation has one memory, either for numbers or for images
        stage_store("eeprom", 400, NULL);
    return stage_start() == SM_OK && (stage.swaps.storage == NULL || stage.store.nvm.id != 0);
}

// Whether the machines that were confirmed last are running.
static bool has_confirmed(void)
{
    for (uint16_t i = 0; i < stage.swaps.machines; i++)
        if (identity(i) != world.confirmed[i])
            return false;
    return true;
}

static void note_confirmed(void)
{
    for (uint16_t i = 0; stage_phase() == SM_SWAP_CONFIRMED && i < stage.swaps.machines; i++)
        world.confirmed[i] = identity(i);
}

static void tick(void)
{
    SmApp *const app = &stage.app;
    uint8_t before[STAGE_SIZE];

    if (++world.ticks > TICKS_MOST)
        return;
    memcpy(before, stage.swaps.sv->at, STAGE_SIZE);
    sm_swaps_write(app, PAL_MILLISECOND);
    FUZZ_CHECK(memcmp(before, stage.swaps.sv->at, STAGE_SIZE) == 0);      // only a tick changes the state vector
    stage_tick(0);
    FUZZ_CHECK(stage.machine[0].machine->last_state != 0 && stage.calls[0] == stage.executor[0].ticks);
    note_confirmed();
}

static void begin(uint8_t flags)
{
    memset(&world, 0, sizeof world);
    world.flags = flags;
    world.plan = (StagePlan){.a = &one, .b = flags & FLAG_TWO ? &b_one : NULL, .room = 4096, .trial = 40, .longest = 2000, .decoded = (flags & FLAG_DECODED) != 0};
    sim_reset();
    memcpy(sim_nvm("flash"), digits, sizeof digits - 1);
    FUZZ_CHECK(start());
    world.confirmed[0] = stage_identity(&one);
    world.confirmed[1] = stage_identity(&b_one);
    tick();
}

static void restart(void)
{
    static uint8_t content[2][SIM_NVM_SIZE];
    const bool is_stored = stage.swaps.storage != NULL;
    const uint32_t newest = stage.link.newest;

    memcpy(content[0], sim_nvm("eeprom"), SIM_NVM_SIZE);
    memcpy(content[1], sim_nvm("flash"), SIM_NVM_SIZE);
    sim_reset();
    memcpy(sim_nvm("eeprom"), content[0], SIM_NVM_SIZE);
    memcpy(sim_nvm("flash"), content[1], SIM_NVM_SIZE);
    FUZZ_CHECK(start());
    if (!is_stored) {
        world.confirmed[0] = stage_identity(&one);
        world.confirmed[1] = stage_identity(&b_one);
    }
    FUZZ_CHECK(has_confirmed() && stage.link.newest == newest);
}

// ---- hosts ----

static void connect_host(Host *h)
{
    const PalAddress at = {{127, 0, 0, 1}, 4711};

    if (h->is_open)
        (void)pal_socket_close(h->stream);
    h->is_open = pal_socket_connect(&h->stream, &at, 0) == SM_OK;
    sm_link_receiver_init(&h->in, h->received, sizeof h->received);
}

// Receives the answers of the application.  All of them must be valid frames.
static void receive_answers(Host *h)
{
    uint8_t bytes[512];
    size_t n = 0;

    while (h->is_open && pal_socket_receive(h->stream, bytes, sizeof bytes, &n, 0) == SM_OK)
        for (size_t i = 0; i < n; i++) {
            const bool is_whole = sm_link_receive(&h->in, bytes[i]);
            FUZZ_CHECK(is_whole == (bytes[i] == 0));
            FUZZ_CHECK(!is_whole || (h->in.n > LINK_HEAD && (h->in.buffer[1] & LINK_ANSWER) != 0));
        }
}

static void serve(void)
{
    sm_swap_link_serve(&stage.link.service, PAL_MILLISECOND);
    for (int i = 0; i < HOSTS; i++)
        receive_answers(&world.host[i]);
    note_confirmed();
}

static void send_raw(Host *h, const uint8_t *bytes, size_t n)
{
    size_t sent;

    if (!h->is_open)
        connect_host(h);
    if (h->is_open && pal_socket_send(h->stream, bytes, n, &sent, 0) == SM_E_CLOSED)
        h->is_open = pal_socket_close(h->stream) != SM_OK;
    serve();
}

static void send_frame(Host *h, uint8_t message, const uint8_t *body, size_t n)
{
    uint8_t frame[LINK_ROOM(LINK_BODY_MAX)] = {0};

    n = n < LINK_BODY_MAX ? n : LINK_BODY_MAX;
    frame[1] = 7;
    frame[2] = message;
    memcpy(frame + 1 + LINK_HEAD, body, n);
    send_raw(h, frame, sm_link_encode(frame, (uint16_t)(LINK_HEAD + n)));
}

// Maps a byte to a message.  A number of link.def is this message.  Other bytes below 128 select one of the messages.
static uint8_t message_of(uint8_t byte)
{
    static const uint8_t messages[] = {LINK_APP, LINK_MACHINE, LINK_SWAP, LINK_KEPT, LINK_BEGIN, LINK_DATA, LINK_END, LINK_CONFIRM, LINK_EVENTS};

    return byte & 0x80 ? byte : messages[byte % sizeof messages];
}

// Signs a swap of n bytes with the next swap number.  Returns the number of bytes with the signature.
static size_t sign(uint8_t *swap, size_t n)
{
    SmvmMac m;

    sm_link_store(swap + n, ++world.number, 4);
    smvm_mac_begin(&m, key);
    for (size_t i = 0; i < n + 4; i++)
        smvm_mac_byte(&m, swap[i]);
    smvm_mac_end(&m, key, swap + n + 4);
    return n + SM_SWAP_SIGNATURE;
}

// Sends a changed swap.  `data`: which swap; whether it is changed before or (1) after it is signed; then changes of three bytes each: the
// position as u16, and the change.
static void send_swap(Host *h, const uint8_t *data, size_t n)
{
    static uint16_t session;
    uint8_t swap[SWAP_MOST + SM_SWAP_SIGNATURE], body[LINK_BODY_MAX];
    const Buf *from = &swaps[n > 0 ? data[0] % SWAPS : 0];
    const bool is_signed = (world.flags & FLAG_KEY) != 0, is_late = n > 1 && (data[1] & 1);
    size_t size = from->n;

    FUZZ_CHECK(size <= SWAP_MOST);
    memcpy(swap, from->at, size);
    if (is_signed && is_late)
        size = sign(swap, size);
    for (size_t i = 2; i + 2 < n; i += 3)
        swap[sm_link_load(data + i, 2) % size] ^= data[i + 2];
    if (is_signed && !is_late)
        size = sign(swap, size);
    session = (uint16_t)(session % 1000 + 1);
    sm_link_store(body, session, 2);
    sm_link_store(body + 2, (uint32_t)size, 3);
    sm_link_store(body + 5, sm_crc32(swap, size), 4);
    sm_link_store(body + SMVM_PERMIT_AT, world.number, 4);
    smvm_permit_code(world.number, (uint32_t)size, key, body + SMVM_PERMIT_AT + 4);
    send_frame(h, LINK_BEGIN, body, is_signed ? SMVM_PERMIT_AT + SMVM_PERMIT : SMVM_PERMIT_AT);
    for (size_t at = 0, part; at < size; at += part) {
        part = size - at < 190 ? size - at : 190;
        sm_link_store(body + 2, (uint32_t)at, 3);
        memcpy(body + 5, swap + at, part);
        send_frame(h, LINK_DATA, body, 5 + part);
    }
    send_frame(h, LINK_END, body, 2);
    for (int i = 0; i < 20; i++)
        tick();
}

static void send_confirm(Host *h, uint8_t change)
{
    uint8_t body[4 + SMVM_CODE];

    sm_link_store(body, stage.link.swap_checksum ^ change, 4);
    smvm_confirm_code(stage.link.swap_number, stage.link.swap_checksum, key, body + 4);
    send_frame(h, LINK_CONFIRM, body, sizeof body);
}

// ---- operations ----

static void run_operation(uint8_t kind, const uint8_t *data, size_t n)
{
    Host *h = &world.host[(kind & 15) % HOSTS];

    switch (kind / 16 % OPS) {
    case OP_RAW: send_raw(h, data, n); break;
    case OP_FRAME:
        if (n > 0)
            send_frame(h, message_of(data[0]), data + 1, n - 1);
        break;
    case OP_SWAP: send_swap(h, data, n); break;
    case OP_CONFIRM: send_confirm(h, n > 0 ? data[0] : 0); break;
    case OP_TICKS:
        for (size_t i = 0; i < n; i++)
            tick();
        break;
    case OP_SLEEP: (void)pal_clock_sleep_until(pal_clock_now() + n * 50 * (uint64_t)PAL_MILLISECOND); break;
    case OP_RECONNECT: connect_host(h); break;
    default: stage_arm(n % 2 != 0); break;
    }
}

static void set_up(void)
{
    const uint8_t modes[] = {SM_SWAP_CONTINUE, SM_SWAP_RESTART};

    machine_compile(&one, COUNT(1), STAGE_SV, 2, true);
    machine_compile(&ten, COUNT(10), STAGE_SV, 2, true);
    machine_compile(&b_one, COUNT_B(1), STAGE_SV, 2, true);
    machine_compile(&b_ten, COUNT_B(10), STAGE_SV, 2, true);
    for (int i = 0; i < SMVM_KEY; i++)
        key[i] = (uint8_t)(i * 0x11);
    for (int i = 0; i < SWAPS; i++) {
        const ApplicationChange change[] = {{"a", modes[i % 2], i == 1 ? "A" : NULL, i == 3 ? NULL : ten.image, i == 3 ? 0 : ten.image_size},
                                            {"b", modes[i % 2], NULL, b_ten.image, b_ten.image_size}};
        buf_init(&swaps[i], &one.session.arena);
        application_write_swap(change, i == 4 ? 2 : 1, NULL, 0, &swaps[i]);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (swaps[0].n == 0)
        set_up();
    if (size < 3 || size > 4096)
        return 0;
    begin(data[0]);
    for (size_t at = 1; at + 2 <= size && world.ticks < TICKS_MOST;) {
        const size_t n = data[at + 1] < size - at - 2 ? data[at + 1] : size - at - 2;
        run_operation(data[at], data + at + 2, n);
        at += 2 + n;
    }
    fuzz_reached += stage_events(SM_EVENT_SWAP, NULL) > 0;
    sm_swaps_close(&stage.app, NULL);
    note_confirmed();
    restart();
    return 0;
}
