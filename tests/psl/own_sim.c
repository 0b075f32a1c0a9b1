// SPDX-License-Identifier: Apache-2.0
// The guarantees of the simulated platform beyond the headers: control of time, and faults on request.
#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/console.h"
#include "runtime-c/pal/aio.h"
#include "runtime-c/pal/dio.h"
#include "runtime-c/pal/lock.h"
#include "runtime-c/pal/log.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/pal/socket.h"
#include "runtime-c/pal/watchdog.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/psl/suite.h"

static void time_moves_by_hand(void)
{
    uint64_t start;

    sim_reset();
    start = pal_clock_now();
    CHECK(start == PAL_SECOND && pal_clock_now() == start);
    sim_advance(5);
    CHECK(pal_clock_now() == start + 5);
    CHECK(pal_clock_sleep_until(start + 100) == SM_OK && pal_clock_now() == start + 100);
    sim_oversleep(7);
    CHECK(pal_clock_sleep_until(start + 200) == SM_OK && pal_clock_now() == start + 207);
    CHECK(pal_clock_sleep_until(start) == SM_OK && pal_clock_now() == start + 207);
    sim_delay(SIM_console_write, 1000);                   // a call with a duration
    CHECK(pal_console_write("hello", 5) == SM_OK && pal_clock_now() == start + 1207);
    CHECK(strcmp(sim_console(), "hello") == 0);
}

static uint64_t world_at[8];
static unsigned world_calls;

static void step_world(void)
{
    world_at[world_calls++ % COUNT(world_at)] = pal_clock_now();
}

// The simulated world keeps its period, however calls advance time.
static void test_world_keeps_its_period(void)
{
    sim_reset();
    world_calls = 0;
    sim_every(10, step_world);
    sim_advance(9);
    CHECK(world_calls == 0);
    sim_advance(1);
    CHECK(world_calls == 1 && world_at[0] == PAL_SECOND + 10);
    CHECK(pal_clock_sleep_until(PAL_SECOND + 35) == SM_OK && pal_clock_now() == PAL_SECOND + 35);
    CHECK(world_calls == 3 && world_at[1] == PAL_SECOND + 20 && world_at[2] == PAL_SECOND + 30);
    sim_delay(SIM_console_write, 5);
    CHECK(pal_console_write("x", 1) == SM_OK && world_calls == 4 && world_at[3] == PAL_SECOND + 40);
    sim_every(0, step_world);
    sim_advance(100);
    CHECK(world_calls == 4);
    sim_every(10, step_world);
    sim_reset();
    sim_advance(100);
    CHECK(world_calls == 4);
}

static void console_is_full(void)
{
    const char text[100] = {'x'};
    SmResult r = SM_OK;

    sim_reset();
    CHECK(sim_console()[0] == '\0');
    for (int i = 0; i < 100 && r == SM_OK; i++)
        r = pal_console_write(text, sizeof text);
    CHECK(r == SM_E_BUSY && sim_count(SIM_console_write) == 41);
}

static void test_faults(void)
{
    PalDio pin = {0};
    PalLock lock = {0};

    sim_reset();
    CHECK(pal_dio_open(&pin, 4, PAL_DIO_OUTPUT, false) == SM_OK);
    sim_fail(SIM_dio_write, 2, SM_E_DEVICE);
    CHECK(pal_dio_write(pin, true) == SM_OK);
    CHECK(pal_dio_write(pin, false) == SM_OK);
    CHECK(pal_dio_write(pin, true) == SM_E_DEVICE && !sim_pin(4));
    CHECK(pal_dio_write(pin, true) == SM_OK && sim_pin(4));
    sim_break(SIM_dio_write, 1, SM_E_DEVICE);
    CHECK(pal_dio_write(pin, false) == SM_OK);
    for (int i = 0; i < 3; i++)
        CHECK(pal_dio_write(pin, true) == SM_E_DEVICE && !sim_pin(4));
    sim_break(SIM_dio_write, 0, SM_OK);
    CHECK(pal_dio_write(pin, true) == SM_OK);
    CHECK(sim_count(SIM_dio_write) == 9 && sim_count(SIM_dio_read) == 0);
    CHECK(pal_lock_open(&lock) == SM_OK);
    sim_fail(SIM_lock_take, 0, SM_E_TIMEOUT);
    CHECK(pal_lock_take(lock, 0) == SM_E_TIMEOUT && pal_lock_take(lock, 0) == SM_OK);
    sim_reset();
    CHECK(pal_dio_write(pin, true) == SM_E_HANDLE && sim_count(SIM_dio_write) == 0);
}

static bool reads(uint16_t number, PalDioMode mode)
{
    PalDio pin = {0};
    bool level = false;

    CHECK(pal_dio_open(&pin, number, mode, false) == SM_OK);
    CHECK(pal_dio_read(pin, &level) == SM_OK);
    CHECK(pal_dio_close(pin) == SM_OK);
    return level;
}

static void test_pins(void)
{
    PalDio pin = {0};

    sim_reset();
    CHECK(!reads(5, PAL_DIO_INPUT) && !reads(5, PAL_DIO_PULL_DOWN) && reads(5, PAL_DIO_PULL_UP));
    sim_drive(5, true);
    CHECK(reads(5, PAL_DIO_INPUT) && reads(5, PAL_DIO_PULL_DOWN));
    sim_drive(5, false);
    CHECK(!reads(5, PAL_DIO_PULL_UP));
    sim_wire(6, 7);
    CHECK(pal_dio_open(&pin, 6, PAL_DIO_OUTPUT, false) == SM_OK);
    CHECK(sim_count_pin_changes(6) == 0);                             // low from the start, without a pulse
    for (int i = 0; i < 3; i++)
        CHECK(pal_dio_write(pin, true) == SM_OK);
    CHECK(sim_count_pin_changes(6) == 1 && sim_count_pin_changes(7) == 1 && sim_pin(7));
    CHECK(pal_dio_close(pin) == SM_OK && sim_pin(6));     // close changes nothing
}

static void test_channels(void)
{
    PalAio in = {0};
    int32_t x = 7;

    sim_reset();
    CHECK(pal_aio_open(&in, 3, PAL_AIO_INPUT) == SM_OK);
    sim_set_analog(3, -1234567);
    CHECK(pal_aio_read(in, &x) == SM_OK && x == -1234565 && sim_analog(3) == x);
    sim_fail(SIM_aio_read, 0, SM_E_DEVICE);
    CHECK(pal_aio_read(in, &x) == SM_E_DEVICE && x == -1234565);
}

// ---- the network ----

static PalSocket socket_at(uint16_t port)
{
    PalSocket s = {0};
    PalAddress a = {{10, 0, 0, 1}, 0};

    a.port = port;
    CHECK(pal_socket_udp(&s, &a) == SM_OK);
    return s;
}

// Sends one datagram for each letter.
static void send_letters(PalSocket s, const char *letters)
{
    const PalAddress to = {{10, 0, 0, 1}, 2000};

    for (; *letters; letters++)
        CHECK(pal_socket_send_to(s, &to, letters, 1) == SM_OK);
}

// Returns the letters that arrive within the timeout, in order.
static const char *receive_letters(PalSocket s, uint64_t timeout)
{
    static char text[32];
    size_t n = 0, got;

    while (n + 1 < sizeof text && pal_socket_receive_from(s, NULL, text + n, 1, &got, timeout) == SM_OK)
        n += got;
    text[n] = '\0';
    return text;
}

// A message that is sent later over a faster network arrives first.  Its arrival wakes a waiting thread.
static void test_overtaking(PalSocket a, PalSocket b)
{
    const SimNetwork slow = {10 * MS, 0, 0, 0}, fast = {MS, 0, 0, 0};
    uint64_t before = pal_clock_now();
    uint8_t x = 0;
    size_t n = 0;

    sim_network(slow);
    send_letters(a, "a");
    sim_network(fast);
    send_letters(a, "b");
    CHECK(pal_socket_receive_from(b, NULL, &x, 1, &n, PAL_SECOND) == SM_OK && x == 'b');
    CHECK(pal_clock_now() == before + MS);
    CHECK(pal_socket_receive_from(b, NULL, &x, 1, &n, PAL_SECOND) == SM_OK && x == 'a');
    CHECK(pal_clock_now() == before + 10 * MS);
}

static void test_datagrams(void)
{
    const SimNetwork lossy = {0, 3, 0, 0}, doubling = {0, 0, 2, 0}, swapping = {0, 0, 0, 2}, slow = {10 * MS, 0, 0, 0};
    PalSocket a, b;

    sim_reset();
    a = socket_at(1000);
    b = socket_at(2000);
    send_letters(a, "abcd");
    CHECK(strcmp(receive_letters(b, 0), "abcd") == 0);
    sim_network(lossy);
    send_letters(a, "abcdef");
    CHECK(strcmp(receive_letters(b, 0), "abde") == 0);
    sim_network(doubling);
    send_letters(a, "abcd");
    CHECK(strcmp(receive_letters(b, 0), "abbcdd") == 0);
    sim_network(swapping);
    send_letters(a, "abcdef");
    CHECK(strcmp(receive_letters(b, 0), "acbedf") == 0);         // no message follows the last one, so it is not reordered
    sim_network(slow);
    send_letters(a, "ab");
    CHECK(strcmp(receive_letters(b, 9 * MS), "") == 0);
    CHECK(strcmp(receive_letters(b, MS), "ab") == 0);
    test_overtaking(a, b);
}

// ---- waits that the world ends ----

// Each call waits up to 100 ns.  The world acts after 10 and 20 ns, and its action ends the wait at exactly that time.
static unsigned world_turn;
static PalSocket world_socket;
static const PalAddress world_to = {{127, 0, 0, 1}, 2000};

static bool is_second_turn(void) { return ++world_turn == 2; }

static void begin_wait(void (*act)(void))
{
    world_turn = 0;
    sim_every(10, act);
}

static bool took(uint64_t since, uint64_t ns)
{
    return pal_clock_now() - since == ns;
}

static void sends_to_line(void) { if (is_second_turn()) sim_serial_send("serial0", "hi", 2); }
static void unplugs_line(void) { if (is_second_turn()) sim_serial_plug("serial0", false); }
static void sends_on_line(void)
{
    static uint8_t bytes[100];

    (void)sim_serial_receive("serial0", bytes, sizeof bytes);
}

static void waits_for_a_line(void)
{
    static const uint8_t many[65536];
    PalSerial line = {0};
    char text[8] = {0};
    uint64_t start;
    size_t n = 7;

    sim_reset();
    CHECK(pal_serial_open(&line, "serial0", 9600) == SM_OK);
    begin_wait(sends_to_line);
    start = pal_clock_now();
    CHECK(pal_serial_receive(line, text, sizeof text, &n, 100) == SM_OK && n == 2 && memcmp(text, "hi", 2) == 0 && took(start, 20));
    start = pal_clock_now();
    CHECK(pal_serial_receive(line, text, sizeof text, &n, 15) == SM_E_TIMEOUT && n == 2 && took(start, 15));
    sim_every(0, NULL);
    CHECK(pal_serial_send(line, many, sizeof many, &n, 0) == SM_E_TIMEOUT && n > 0);      // the line is full
    begin_wait(sends_on_line);
    start = pal_clock_now();
    CHECK(pal_serial_send(line, many, 250, &n, 100) == SM_OK && n == 250 && took(start, 30));
    begin_wait(unplugs_line);
    start = pal_clock_now();
    CHECK(pal_serial_receive(line, text, sizeof text, &n, 100) == SM_E_CLOSED && took(start, 20));
}

static void sends_datagram(void) { if (is_second_turn()) CHECK(pal_socket_send_to(world_socket, &world_to, "d", 1) == SM_OK); }
static void connects(void) { if (is_second_turn()) CHECK(pal_socket_connect(&world_socket, &world_to, 0) == SM_OK); }
static void sends_on_stream(void)
{
    size_t n;

    if (is_second_turn())
        CHECK(pal_socket_send(world_socket, "s", 1, &n, 0) == SM_OK);
}
static void receives_on_stream(void)
{
    static uint8_t bytes[100];
    size_t n;

    CHECK(pal_socket_receive(world_socket, bytes, sizeof bytes, &n, 0) == SM_OK && n == sizeof bytes);
}
static void closes_stream(void) { if (is_second_turn()) CHECK(pal_socket_close(world_socket) == SM_OK); }

static void waits_for_a_datagram(void)
{
    const SimNetwork slow = {5, 0, 0, 0};
    PalSocket s = {0};
    uint64_t start;
    char x = 0;
    size_t n = 7;

    sim_reset();
    CHECK(pal_socket_udp(&s, &world_to) == SM_OK);
    CHECK(pal_socket_udp(&world_socket, &(PalAddress){{127, 0, 0, 1}, 1000}) == SM_OK);
    begin_wait(sends_datagram);
    start = pal_clock_now();
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 100) == SM_OK && n == 1 && x == 'd' && took(start, 20));
    sim_network(slow);
    begin_wait(sends_datagram);
    start = pal_clock_now();
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 100) == SM_OK && took(start, 25));
    begin_wait(sends_datagram);
    start = pal_clock_now();
    CHECK(pal_socket_receive_from(s, NULL, &x, 1, &n, 24) == SM_E_TIMEOUT && took(start, 24));
}

static void waits_for_a_stream(void)
{
    static const uint8_t many[65536];
    PalSocket listening = {0}, s = {0};
    uint64_t start;
    char x = 0;
    size_t n = 7;

    sim_reset();
    CHECK(pal_socket_listen(&listening, &world_to) == SM_OK);
    begin_wait(connects);
    start = pal_clock_now();
    CHECK(pal_socket_accept(listening, &s, NULL, 100) == SM_OK && took(start, 20));
    begin_wait(sends_on_stream);
    start = pal_clock_now();
    CHECK(pal_socket_receive(s, &x, 1, &n, 100) == SM_OK && n == 1 && x == 's' && took(start, 20));
    sim_every(0, NULL);
    CHECK(pal_socket_send(s, many, sizeof many, &n, 0) == SM_E_TIMEOUT && n > 0);         // the stream is full
    begin_wait(receives_on_stream);
    start = pal_clock_now();
    CHECK(pal_socket_send(s, many, 250, &n, 100) == SM_OK && n == 250 && took(start, 30));
    begin_wait(closes_stream);
    start = pal_clock_now();
    CHECK(pal_socket_receive(s, &x, 1, &n, 100) == SM_E_CLOSED && took(start, 20));
}

// ---- non-volatile memory ----

// Writes eight bytes over 'o's, and cuts the power after n bytes.  Returns the content.
static const char *content_after_cut(uint32_t bytes)
{
    static char text[11];
    PalNvm memory = {0}, other = {0};

    sim_reset();
    CHECK(pal_nvm_open(&memory, "eeprom", 16) == SM_OK);
    CHECK(pal_nvm_write(memory, 0, "oooooooooo", 10) == SM_OK);
    sim_cut_power(1, bytes);
    CHECK(pal_nvm_write(memory, 9, "e", 1) == SM_OK);     // the byte outside the interrupted write is undamaged
    CHECK(pal_nvm_write(memory, 1, "nnnnnnnn", 8) == SM_E_DEVICE);
    CHECK(pal_nvm_read(memory, 0, text, 10) == SM_E_DEVICE);
    CHECK(pal_nvm_write(memory, 0, "x", 1) == SM_E_DEVICE && pal_nvm_erase(memory, 0, 1) == SM_E_DEVICE);
    CHECK(pal_nvm_open(&other, "flash", 16) == SM_E_DEVICE && pal_nvm_open(&other, "eeprom", 16) == SM_E_DEVICE && other.id == 0);
    sim_power_on();
    CHECK(pal_nvm_read(memory, 0, text, 10) == SM_E_HANDLE);
    CHECK(pal_nvm_open(&memory, "eeprom", 16) == SM_OK);
    CHECK(pal_nvm_read(memory, 0, text, 10) == SM_OK);
    return text;
}

static void torn_writes(void)
{
    CHECK(strcmp(content_after_cut(0), "o\xa5" "ooooooo" "e") == 0);
    CHECK(strcmp(content_after_cut(3), "onnn\xa5" "oooo" "e") == 0);
    CHECK(strcmp(content_after_cut(8), "onnnnnnnn" "e") == 0);    // all bytes are written, although the call failed
}

// Writes that the flash allows and refuses.
static void test_flash(void)
{
    PalNvm memory = {0};
    PalNvmInfo info;
    uint8_t x[32] = {0};

    sim_reset();
    CHECK(pal_nvm_open(&memory, "flash", SIM_NVM_SIZE) == SM_OK);
    CHECK(pal_nvm_info(memory, &info) == SM_OK && info.write == 8 && info.erase == 32);
    CHECK(pal_nvm_write(memory, 8, x, 8) == SM_OK);
    CHECK(pal_nvm_write(memory, 8, x, 8) == SM_E_ARGUMENT);       // not erased
    CHECK(pal_nvm_write(memory, 4, x, 8) == SM_E_ARGUMENT);
    CHECK(pal_nvm_erase(memory, 0, 16) == SM_E_ARGUMENT);
    CHECK(pal_nvm_erase(memory, 0, 32) == SM_OK);
    CHECK(pal_nvm_write(memory, 8, x, 8) == SM_OK);
    sim_cut_power(0, 9);
    CHECK(pal_nvm_erase(memory, 0, 32) == SM_E_DEVICE);
    sim_power_on();
    CHECK(pal_nvm_open(&memory, "flash", 1) == SM_OK);
    CHECK(pal_nvm_read(memory, 0, x, 32) == SM_OK && x[8] == 0xff && x[9] == 0xa5 && x[10] == 0);
    CHECK(pal_nvm_close(memory) == SM_OK);
    CHECK(pal_nvm_open(&memory, "flash", SIM_NVM_SIZE + 1) == SM_E_SPACE);
}

// A log after a power cut in its second append.
static void test_torn_log(void)
{
    PalLogFile file = {0}, more = {0}, third = {0};
    const uint8_t *bytes;
    uint64_t size = 99;
    char text[2] = {0};
    size_t n;

    sim_reset();
    CHECK(sim_log("a", &n) == NULL && n == 0);
    CHECK(pal_log_open(&file, "a") == SM_OK && pal_log_append(file, "12", 2) == SM_OK && pal_log_sync(file) == SM_OK);
    sim_cut_power(1, 2);
    CHECK(pal_log_append(file, "34", 2) == SM_OK && sim_log_synced("a") == 2);
    CHECK(pal_log_append(file, "5678", 4) == SM_E_DEVICE && pal_log_append(file, "9", 1) == SM_E_DEVICE);
    CHECK(pal_log_sync(file) == SM_E_DEVICE && pal_log_read(file, text, 2) == SM_E_DEVICE && text[0] == 0);
    CHECK(pal_log_size(file, &size) == SM_E_DEVICE && size == 99);
    CHECK(pal_log_open(&more, "b") == SM_E_DEVICE && more.id == 0);
    sim_power_on();
    bytes = sim_log("a", &n);
    CHECK(n == 7 && memcmp(bytes, "123456\xa5", 7) == 0);
    CHECK(pal_log_append(file, "x", 1) == SM_E_HANDLE);
    CHECK(pal_log_open(&file, "a") == SM_OK && pal_log_open(&more, "b") == SM_OK);
    CHECK(pal_log_close(more) == SM_OK && pal_log_open(&third, "c") == SM_E_SPACE);
    sim_log_space(9);
    CHECK(pal_log_append(file, "wxyz", 4) == SM_E_SPACE && memcmp(sim_log("a", &n) + 7, "wx", 2) == 0 && n == 9);
}

static void bites(void)
{
    uint64_t actual;
    bool bit = true;

    sim_reset();
    CHECK(pal_watchdog_start(10 * MS - 1, &actual) == SM_OK && actual == 10 * MS);
    for (int i = 0; i < 5; i++) {
        sim_advance(actual);
        CHECK(!sim_watchdog_fired() && pal_watchdog_feed() == SM_OK);
    }
    CHECK(pal_watchdog_caused_start(&bit) == SM_OK && !bit);
    sim_advance(actual + 1);
    CHECK(sim_watchdog_fired() && pal_watchdog_caused_start(&bit) == SM_OK && bit);
    sim_reset();
    CHECK(!sim_watchdog_fired());
}

Tally own_sim(void)
{
    time_moves_by_hand();
    test_world_keeps_its_period();
    console_is_full();
    test_faults();
    test_pins();
    test_channels();
    test_datagrams();
    waits_for_a_line();
    waits_for_a_datagram();
    waits_for_a_stream();
    torn_writes();
    test_torn_log();
    test_flash();
    bites();
    return TALLY();
}
