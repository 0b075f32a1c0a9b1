// SPDX-License-Identifier: Apache-2.0
// Boards with older firmware: their answers lack the fields that were added later, and the host reads them as absent.  The line of this test
// answers each request with the same bytes.  And memory that older firmware has written: newer firmware runs what is in it.
//   older PARAMETERS.smb
#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/device/device.h"
#include "tests/store/image.h"
#include "tests/test.h"

typedef struct Canned {
    uint8_t body[LINK_BODY_MAX];
    size_t n;                 // the number of bytes in the answer, after its result
    uint8_t answer[LINK_ROOM(LINK_BODY_MAX)];
    size_t length, given;
    LinkReceiver in;
    uint8_t arrived[LINK_ROOM(LINK_BODY_MAX)];
    uint32_t now;
} Canned;

static bool canned_send(void *context, const uint8_t *bytes, size_t n)
{
    Canned *c = context;

    for (size_t i = 0; i < n; i++)
        if (sm_link_receive(&c->in, bytes[i])) {
            c->answer[1] = c->in.buffer[0];
            c->answer[2] = (uint8_t)(c->in.buffer[1] | LINK_ANSWER);
            c->answer[3] = SM_OK;
            memcpy(c->answer + 4, c->body, c->n);
            c->length = sm_link_encode(c->answer, (uint16_t)(LINK_HEAD + 1 + c->n));
            c->given = 0;
        }
    return true;
}

static int canned_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait)
{
    Canned *c = context;
    size_t n = 0;

    while (n < room && c->given < c->length)
        bytes[n++] = c->answer[c->given++];
    c->now += n > 0 ? 0 : wait;
    return (int)n;
}

static uint32_t canned_now(void *context) { return ((const Canned *)context)->now; }

// HELLO now has more fields (link.def: "from the signatures on it may be cut").  Fields that a board omits are empty, even if an earlier, longer
// answer is still in the buffer.
static void test_older_boards_report_less(void)
{
    static const uint8_t all[35] = {1, 200, 128, 2, 0, 4, 0, 0, 2, 0, 9, 0, 0, 0, 0, 1, 5, 0, 0, 0, 0xc3, 10, 26, 20, 0, 0x40, 0x1f, 4, 3, 2, 1, 7, 0, 3, 0};
    static const uint8_t none[31] = {0};
    Canned c;
    SerialLine line = {&c, canned_send, canned_receive, canned_now};
    LinkHost host;
    DeviceInfo info;
    DeviceImage image;
    uint8_t place;

    memset(&c, 0, sizeof c);
    sm_link_receiver_init(&c.in, c.arrived, sizeof c.arrived);
    link_host_init(&host, &line, 100, 1, 0);
    for (size_t n = 14; n <= sizeof all; n++) {
        memcpy(c.body, all, c.n = sizeof all);
        CHECK(device_query_info(&host, &info) && info.requires_signature && info.newest == 5 && info.reports_limits && info.windows && info.parameters && info.machines == 3);
        CHECK(info.ram_digital == 10 && info.ram_analog == 26 && info.period == 20 && info.cycles == 8000 && info.reports_mark);
        CHECK(info.mark == 0x01020304 && info.slots == 2 && info.slot_size == 1024 && info.ram == 512 && info.longest == 9);
        c.n = n;
        CHECK(device_query_info(&host, &info) == (n >= 15) && (n >= 15 || host.result == SM_E_UNSUPPORTED));
        CHECK(n < 15 || (info.requires_signature == (n >= 20) && info.newest == (n >= 20 ? 5 : 0)));
        CHECK(n < 15 || (info.reports_limits == (n >= 27) && info.windows == (n >= 27) && info.parameters == (n >= 27) && info.machines == (n >= 27 ? 3 : 0)));
        CHECK(n < 15 || info.functions == (n >= 35 ? 0x30007 : 0));
        CHECK(n < 15 || (info.period == (n >= 27 ? 20 : 0) && info.reports_mark == (n >= 31) && info.mark == (n >= 31 ? 0x01020304 : 0)));
    }
    memcpy(c.body, all, c.n = sizeof all);
    c.body[20] = 3;                        // up to three machines, without windows and parameters
    CHECK(device_query_info(&host, &info) && !info.windows && !info.parameters && info.machines == 3);
    memcpy(c.body, none, c.n = 20);
    c.body[18] = 44;                       // IMAGE now also has the milliseconds between steps
    CHECK(device_read_image_info(&host, 0, &image) && image.period == 44);
    for (c.n = 17; c.n < 20; c.n++)
        CHECK(device_read_image_info(&host, 0, &image) == (c.n >= 18) && (c.n < 18 || image.period == 0));
    c.n = 0;                               // an answer without a position reports none
    CHECK(!device_find_chip_pin(&host, 2, 3, &place) && host.result == SM_E_UNSUPPORTED);
}

// ---- memory that older firmware has written ----

// The memory of a board with two slots, written by the firmware of 24 November 2026, before images could have parameters: the tank is in slot 0, every
// 20 ms, confirmed.  Newer firmware runs it, and an image with parameters can replace it.
static const uint8_t older_memory[] = {
        0x02, 0x00, 0x00, 0x00, 0x01, 0x00, 0xff, 0x0b, 0x00, 0x00, 0x00, 0x00, 0x2b, 0x03, 0x12, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
        0x14, 0x00, 0x00, 0x00, 0x76, 0x10, 0xbe, 0x7a, 0x03, 0x00, 0x00, 0x00, 0x01, 0x00, 0xff, 0x00, 0x01, 0x00, 0x00, 0x00, 0x2b, 0x03, 0x12, 0x08,
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x14, 0x00, 0x00, 0x00, 0xb8, 0x5d, 0x80, 0x40, 0x73, 0x6d, 0x62, 0x02, 0x2b, 0x03, 0x12, 0x08,
        0x8e, 0x00, 0x00, 0x04, 0x01, 0x01, 0x2c, 0x00, 0x00, 0x08, 0x00, 0x00, 0x81, 0x02, 0x34, 0x00, 0x00, 0x1d, 0x00, 0x00, 0x82, 0x02, 0x51, 0x00,
        0x00, 0x3c, 0x00, 0x00, 0x05, 0x01, 0x8d, 0x00, 0x00, 0x01, 0x00, 0x00, 0xae, 0x43, 0xf3, 0x36, 0x6f, 0x5f, 0xc3, 0xbc, 0x40, 0xfb, 0xf9, 0x1f,
        0x04, 0x00, 0x04, 0x08, 0x00, 0x01, 0x03, 0x01, 0x00, 0x00, 0x00, 0x02, 0x18, 0x00, 0x0a, 0x00, 0x05, 0x37, 0x3c, 0x3c, 0x3c, 0x3c, 0x3c, 0x3c,
        0x3c, 0x8c, 0x00, 0xc7, 0x00, 0xce, 0x99, 0x02, 0xeb, 0x65, 0x27, 0x0c, 0x8c, 0x01, 0xcc, 0x00, 0x87, 0x00, 0x9e, 0x01, 0xc7, 0x00, 0xdf, 0x04,
        0x8c, 0x00, 0xcc, 0x00, 0x99, 0x02, 0xeb, 0x63, 0x14, 0x12, 0xee, 0x65, 0x59, 0x0e, 0x87, 0x00, 0xeb, 0x67, 0x08, 0x07, 0x9c, 0xe4, 0x78, 0x00,
        0x06, 0x40, 0x03, 0xce, 0xcd, 0x03, 0xcd, 0x02, 0x8c, 0x01, 0xcc, 0x00, 0xce, 0x07,};

static void open_older_memory(Store *s, uint8_t damaged)
{
    sim_reset();
    memcpy(sim_nvm("eeprom"), older_memory, sizeof older_memory);
    sim_nvm("eeprom")[2 * STORE_RECORD + 100] ^= damaged;
    CHECK(image_store(s, "eeprom", 2));
}

static void test_older_memory_runs(const Image *with_parameters)
{
    static uint64_t ram[100], sv[8];
    const uint32_t length = sizeof older_memory - 2 * STORE_RECORD;
    const uint8_t *image;
    SmvmVerdict v;
    SmvmMachine m;
    uint8_t slot = 9;
    Store s;

    memset(&s, 0, sizeof s);
    open_older_memory(&s, 0);
    CHECK(smvm_store_boot(&s, &slot) == SM_OK && slot == 0 && s.choice.confirmed && smvm_store_period(&s, 0) == 20);
    image = s.plan.image[0];
    CHECK(image == sim_nvm("eeprom") + 2 * STORE_RECORD && smvm_verify(image, length, &v) == 0);
    CHECK(smvm_machine(image, 0, &m) && m.parameters_size == 0 && smvm_settings_identity(image) != 0);
    CHECK(smvm_init(ram, sizeof ram, &m, &(SmvmVector){sv, m.sv_size, m.layout}, 1) == SM_OK);
    CHECK(image_send(&s, with_parameters) == SM_OK && smvm_store_activate(&s, IMAGE_SESSION, 0) == SM_OK);
    sim_power_on();
    CHECK(image_store(&s, "eeprom", 2) && smvm_store_boot(&s, &slot) == SM_OK && slot == 1);
    CHECK(memcmp(s.plan.image[1], with_parameters->bytes, with_parameters->length) == 0);
    open_older_memory(&s, 1);
    CHECK(smvm_store_boot(&s, &slot) == SM_OK && slot == STORE_BUILT_IN);
}

int main(int argc, char **argv)
{
    static Image with_parameters;

    if (argc != 2 || !image_load(argv[1], &with_parameters)) {
        fprintf(stderr, "older PARAMETERS.smb\n");
        return 2;
    }
    test_older_boards_report_less();
    test_older_memory_runs(&with_parameters);
    return test_end("older-boards");
}
