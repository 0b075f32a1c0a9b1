// SPDX-License-Identifier: Apache-2.0
// Boards with older firmware: their answers lack the fields that were added later, and the host reads them as absent.  The line of this test
// answers each request with the same bytes.
#include <string.h>

#include "compiler/device/device.h"
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

int main(void)
{
    test_older_boards_report_less();
    return test_end("older-boards");
}
