// SPDX-License-Identifier: Apache-2.0
// Machines that a program runs by libsmc: step by step, by columns, from images, with parameters, and one continuing where another one is.
#include <math.h>
#include <stdlib.h>

#include "tests/library/session.h"

static uint32_t find_element(SmcSession *s, SmcMachine m, const char *name)
{
    uint32_t at = 999;

    CHECK(smc_machine_find(s, m, name, &at) == SMC_OK);
    return at;
}

static double get_number(SmcSession *s, SmcMachine m, const char *name)
{
    double x = -1;

    CHECK(smc_machine_get(s, m, find_element(s, m, name), &x) == SMC_OK);
    return x;
}

static void test_running_machines(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank);
    SmcMachine m = 0, other = 0;
    int16_t small = 0;
    uint32_t at;
    double x;

    CHECK(smc_machine_open(s, sm, &m) == SMC_E_STATE);
    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, sm, &m) == SMC_OK && m != 0 && smc_machine_open(s, sm, &other) == SMC_OK && other != m);
    CHECK(smc_machine_state_count(s, m) == 2 && smc_machine_state(s, m) == 1 && is_text(smc_machine_state_name(s, m, 2), "Abort"));
    CHECK(smc_machine_state_marks(s, m, 1) == (SMC_MARK_SAFE | SMC_MARK_SWAP) && smc_machine_state_marks(s, m, 2) == SMC_MARK_ABORT);
    CHECK(smc_machine_state_marks(s, m, 3) == 0 && is_text(smc_machine_state_name(s, m, 0), "") && is_text(smc_machine_state_name(s, m, 3), ""));
    CHECK(smc_machine_variable_count(s, m) == 7);                  // G S p valve small n level; limit is a constant
    CHECK(smc_machine_variable_type(s, m, find_element(s, m, "n")) == SMC_TYPE_U8 && smc_machine_variable_kind(s, m, find_element(s, m, "n")) == SMC_VARIABLE_LOCAL);
    CHECK(smc_machine_variable_type(s, m, find_element(s, m, "p")) == SMC_TYPE_F32 && smc_machine_variable_offset(s, m, find_element(s, m, "S")) == 8);
    CHECK(smc_machine_set(s, m, find_element(s, m, "p"), 750) == SMC_OK && smc_machine_step(s, m, 10) == SMC_OK);
    CHECK(get_number(s, m, "valve") == 1 && get_number(s, m, "n") == 4 && get_number(s, m, "level") == 1.75 && get_number(s, m, "small") == 4000 && get_number(s, m, "S") == 1 && get_number(s, m, "G") == 10);
    CHECK(smc_machine_variable_stored(s, m, find_element(s, m, "valve")) == 1 && smc_machine_variable_stored(s, m, find_element(s, m, "S")) == 1 && smc_machine_variable_stored(s, m, find_element(s, m, "p")) == 0);
    CHECK(smc_machine_step(s, m, 10) == SMC_E_REFUSED && get_number(s, m, "n") == 4 && smc_machine_step(s, m, 30) == SMC_OK && smc_machine_time(s, m) == 20);
    CHECK(smc_machine_read(s, m, find_element(s, m, "small"), &small, sizeof small) == SMC_OK && small == 5000);
    CHECK(smc_machine_read(s, m, find_element(s, m, "small"), &small, 4) == SMC_E_SIZE && smc_machine_write(s, m, find_element(s, m, "small"), &small, 1) == SMC_E_SIZE);
    small = -7;
    CHECK(smc_machine_write(s, m, find_element(s, m, "small"), &small, sizeof small) == SMC_OK && get_number(s, m, "small") == -7);
    CHECK(smc_machine_set(s, m, find_element(s, m, "small"), 1e9) == SMC_OK && get_number(s, m, "small") == 32767);
    CHECK(smc_machine_set(s, m, find_element(s, m, "n"), 200) == SMC_OK && smc_machine_set(s, m, find_element(s, m, "p"), 950) == SMC_OK && smc_machine_step(s, m, 40) == SMC_OK);
    CHECK(get_number(s, m, "n") == 201 && smc_machine_state(s, m) == 2 && get_number(s, m, "S") == 1);
    CHECK(smc_machine_start(s, m, 3) == SMC_E_INDEX && smc_machine_start(s, m, 2) == SMC_OK && get_number(s, m, "S") == 2 && get_number(s, m, "n") == 3 && get_number(s, m, "p") == 0);
    CHECK(get_number(s, other, "n") == 3 && smc_machine_info(s, m, SMC_INFO_VECTOR) == 24 && smc_machine_info(s, m, SMC_INFO_LONGEST_STEP) > 3);
    CHECK(smc_machine_info(s, m, SMC_INFO_IMAGE) > 100 && smc_machine_info(s, m, 99) == 0 && smc_machine_vector(s, m) != NULL);
    CHECK(smc_machine_info(s, m, SMC_INFO_LAYOUT) == smc_machine_info(s, other, SMC_INFO_LAYOUT));
    CHECK(smc_machine_find(s, m, "nothing", &at) == SMC_E_INDEX && smc_machine_get(s, m, 7, &x) == SMC_E_INDEX && smc_machine_variable_type(s, m, 7) == -1);
    CHECK(smc_machine_close(s, m) == SMC_OK && smc_machine_close(s, m) == SMC_E_HANDLE && smc_machine_step(s, m, 50) == SMC_E_HANDLE);
    CHECK(smc_sources_clear(s) == SMC_OK && smc_machine_step(s, other, 10) == SMC_OK);
    smc_close(s);
}

// A run on columns has the same effect as the same number of steps.
static void test_running_columns(void)
{
    enum { ROWS = 3000 };
    static uint64_t g[ROWS];
    static double p[ROWS], valve[ROWS], small[ROWS], level[ROWS], s_of[ROWS];
    static uint32_t states[ROWS];
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank);
    SmcMachine m = 0, other = 0;
    uint64_t done = 9;

    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, sm, &m) == SMC_OK && smc_machine_open(s, sm, &other) == SMC_OK);
    for (int i = 0; i < ROWS; i++) {
        g[i] = (uint64_t)i * 10;
        p[i] = i == 2500 ? 901 : i % 7 == 3 ? i % 800 + 0.3 : 690 + i % 20;
    }
    {
        const uint32_t input[] = {find_element(s, m, "p")}, output[] = {find_element(s, m, "valve"), find_element(s, m, "small"), find_element(s, m, "level"), find_element(s, m, "S")};
        const double *const from[] = {p};
        double *const to[] = {valve, small, level, s_of};
        CHECK(smc_machine_run(s, m, ROWS, g, 1, input, from, 4, output, to, states, &done) == SMC_OK && done == ROWS);
        for (int i = 0; i < ROWS; i++) {
            smc_machine_set(s, other, input[0], p[i]);
            CHECK(smc_machine_step(s, other, g[i]) == SMC_OK && smc_machine_state(s, other) == states[i] && get_number(s, other, "valve") == valve[i]);
            CHECK(get_number(s, other, "small") == small[i] && get_number(s, other, "level") == level[i] && get_number(s, other, "S") == s_of[i]);
        }
        CHECK(states[2499] == 1 && s_of[2500] == 1 && states[2500] == 2 && s_of[2501] == 2 && small[100] == 32767);
    }
    CHECK(smc_machine_run(s, m, 0, NULL, 0, NULL, NULL, 0, NULL, NULL, NULL, &done) == SMC_OK && done == 0);
    CHECK(smc_machine_step(s, m, g[ROWS - 1]) == SMC_E_REFUSED && smc_machine_step(s, m, g[ROWS - 1] + 1) == SMC_OK);
    smc_close(s);
}

// A refused run on columns changes nothing.
static void test_wrong_columns_are_refused(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank);
    uint64_t g[] = {10, 20, 20, 30}, late[] = {50, UINT64_MAX, 60, 70}, done = 9;
    const double p[] = {1, 2, 3, 4};
    double n[4] = {-1, -1, -1, -1};
    const double *const from[] = {p}, *const no_from[] = {NULL};
    double *const to[] = {n}, *const no_to[] = {NULL};
    uint32_t input, output, time;
    const uint32_t none = 7;
    SmcMachine m = 0;

    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, sm, &m) == SMC_OK);
    input = find_element(s, m, "p");
    output = find_element(s, m, "n");
    time = find_element(s, m, "G");
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, from, 1, &output, to, NULL, NULL) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, NULL, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_ARGUMENT && done == 0);
    CHECK(smc_machine_run(s, m, 4, g, 1, NULL, from, 1, &output, to, NULL, &done) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, NULL, 1, &output, to, NULL, &done) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, from, 1, NULL, to, NULL, &done) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, from, 1, &output, NULL, NULL, &done) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, no_from, 1, &output, to, NULL, &done) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, from, 1, &output, no_to, NULL, &done) == SMC_E_ARGUMENT);
    CHECK(smc_machine_run(s, m, 4, g, 1, &time, from, 1, &output, to, NULL, &done) == SMC_E_ARGUMENT && strstr(smc_error_text(s), "G cannot") != NULL);
    CHECK(smc_machine_run(s, m, 4, g, 1, &none, from, 1, &output, to, NULL, &done) == SMC_E_INDEX);
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, from, 1, &none, to, NULL, &done) == SMC_E_INDEX);
    CHECK(smc_machine_run(s, m, UINT64_MAX, g, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_SIZE);
    CHECK(smc_machine_run(s, 5, 4, g, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_HANDLE);
    CHECK(smc_machine_run(NULL, m, 4, g, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_HANDLE);
    CHECK(smc_cancel(s, 1) == SMC_OK && smc_machine_run(s, m, 4, g, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_CANCELLED && done == 0);
    CHECK(n[0] == -1 && get_number(s, m, "n") == 3 && get_number(s, m, "p") == 0);       // no step has run
    CHECK(smc_machine_run(s, m, 4, g, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_REFUSED && done == 2);
    CHECK(n[0] == 4 && n[1] == 5 && n[2] == -1 && get_number(s, m, "p") == 2 && get_number(s, m, "G") == 20);
    CHECK(smc_machine_run(s, m, 4, late, 1, &input, from, 1, &output, to, NULL, &done) == SMC_E_REFUSED && done == 1);      // no step can be at the largest G
    smc_close(s);
}

static void test_opening_images(void)
{
    SmcSession *s = open_session(), *second = open_session();
    const void *bytes;
    unsigned char *image;
    uint64_t size;
    SmcMachine m = 0, there = 0;

    add(s, SMC_KIND_SM, "tank.sm", tank);
    CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output(s, 0, &bytes, &size) == SMC_OK);
    image = malloc((size_t)size);
    CHECK(image != NULL);
    memcpy(image, bytes, (size_t)size);
    CHECK(smc_machine_open_image(s, image, size, 0, &m) == SMC_OK && smc_machine_variable_count(s, m) == 0 && is_text(smc_machine_state_name(s, m, 1), ""));
    CHECK(smc_machine_step(s, m, 5) == SMC_OK && smc_machine_open_image(s, image, size, 1, &m) == SMC_E_INDEX);
    CHECK(smc_machine_open_image(second, image, size, 0, &there) == SMC_OK && smc_machine_step(s, there, 9) == SMC_E_HANDLE && smc_machine_step(second, m, 9) == SMC_E_HANDLE);
    CHECK(smc_machine_open_image(s, image, size - 1, 0, &m) == SMC_E_IMAGE && smc_error_text(s)[0] != '\0');
    for (uint64_t i = 0; i < size; i++) {             // each byte changed: the image is refused, or is harmless
        SmcMachine changed = 0;
        image[i] ^= 0x55;
        if (smc_machine_open_image(s, image, size, 0, &changed) == SMC_OK) {
            smc_machine_step(s, changed, 1);
            CHECK(smc_machine_close(s, changed) == SMC_OK);
        }
        image[i] ^= 0x55;
    }
    free(image);
    smc_close(s);
    smc_close(second);
}

// An image with two machines.
static void test_opening_each_machine(void)
{
    SmcSession *s = open_session();
    static const char second[] = "[state_vector]\nU64 G\nU32 S\nbool v\n[Only]\n.step\n    v = G > 5\n", vector[] = "[Bus]\nU64 G\nU32 S\nF32 p @range 0 1000\nbool valve\nI16 small\nbool v\n";
    const void *bytes;
    uint64_t size;
    uint32_t count = 0;
    SmcMachine m = 0;

    add(s, SMC_KIND_SM, "dir/first.sm", tank);
    add(s, SMC_KIND_SM, "second.sm", second);
    add(s, SMC_KIND_SV, "bus.sv", vector);
    CHECK(smc_option_set(s, SMC_OPTION_NAMES, 1) == SMC_OK && smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK);
    CHECK(smc_output(s, 0, &bytes, &size) == SMC_OK && smc_image_machine_count(s, bytes, size, &count) == SMC_OK && count == 2);
    CHECK(smc_machine_open_image(s, bytes, size, 0, &m) == SMC_OK && is_text(smc_machine_name(s, m), "first") && smc_machine_state_count(s, m) == 2);
    CHECK(smc_machine_open_image(s, bytes, size, 1, &m) == SMC_OK && is_text(smc_machine_name(s, m), "second") && is_text(smc_machine_state_name(s, m, 1), "Only"));
    CHECK(smc_machine_open_image(s, bytes, size, 2, &m) == SMC_E_INDEX && smc_machine_open_image(s, bytes, size, 256, &m) == SMC_E_INDEX);
    CHECK(smc_image_machine_count(s, bytes, size - 1, &count) == SMC_E_IMAGE && smc_image_machine_count(s, NULL, size, &count) == SMC_E_ARGUMENT && count == 2);
    CHECK(smc_image_machine_count(s, bytes, size, NULL) == SMC_E_ARGUMENT && smc_image_machine_count(s, bytes, UINT64_MAX, &count) == SMC_E_SIZE);
    CHECK(smc_image_machine_count(NULL, bytes, size, &count) == SMC_E_HANDLE && smc_image_machine_count(s, "", 0, &count) == SMC_E_IMAGE && is_text(smc_machine_name(s, 0), ""));
    CHECK(smc_option_set(s, SMC_OPTION_NAMES, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output(s, 0, &bytes, &size) == SMC_OK);
    CHECK(smc_machine_open_image(s, bytes, size, 1, &m) == SMC_OK && is_text(smc_machine_name(s, m), ""));
    smc_close(s);
}

// Whether the list has an item of this kind and name, with this fate.
static bool has_item(const SmcSession *s, int32_t kind, const char *name, int32_t fate)
{
    for (uint32_t i = 0; i < smc_swap_item_count(s); i++)
        if (smc_swap_item_kind(s, i) == kind && is_text(smc_swap_item_name(s, i), name))
            return smc_swap_item_fate(s, i) == fate;
    return false;
}

static void test_swap_items_are_listed(void)
{
    SmcSession *s = open_session();
    static const char older[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[local]\nU8 n = 0\nF64 old = 1\nI16 k = 2\n[A] @safe\n.step\n    n = n + 1\n    old = old + k\n"
                                "    k = k + 1\n    v = roll_avg(p, 4) > 1 or roll_max(p, 7) > old\n    n > 9: -> Gone\n[Gone]\n";
    static const char newer[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[local]\nU8 n = 5\nF64 k = 2\nU32 more = 0\n[First]\n[A] @safe\n.step\n    n = n + 2\n    k = k + 1\n"
                                "    more = more + k\n    v = roll_max(p, 4) > more or roll_avg(p, 9) > n\n";
    const uint32_t a = add(s, SMC_KIND_SM, "a.sm", older), b = add(s, SMC_KIND_SM, "b.sm", newer);
    SmcMachine from = 0, to = 0, third = 0;

    CHECK(smc_option_set(s, SMC_OPTION_WARNINGS, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_machine_open(s, a, &third) == SMC_OK);
    add(s, SMC_KIND_SV, "bus.sv", "[Bus]\nU64 G\nU32 S\nF64 p\nbool v\n");
    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, a, &from) == SMC_OK && smc_machine_open(s, b, &to) == SMC_OK && smc_swap_item_count(s) == 0 && smc_swap_item_kind(s, 0) == -1);
    CHECK(smc_swap_compare(s, from, to) == SMC_OK && smc_swap_item_count(s) == 10);
    CHECK(has_item(s, SMC_SWAP_STATE, "A", SMC_SWAP_KEPT) && has_item(s, SMC_SWAP_STATE, "First", SMC_SWAP_ADDED) && has_item(s, SMC_SWAP_STATE, "Gone", SMC_SWAP_REMOVED));
    CHECK(has_item(s, SMC_SWAP_LOCAL, "n", SMC_SWAP_KEPT) && has_item(s, SMC_SWAP_LOCAL, "k", SMC_SWAP_CHANGED) && has_item(s, SMC_SWAP_LOCAL, "more", SMC_SWAP_ADDED));
    CHECK(has_item(s, SMC_SWAP_LOCAL, "old", SMC_SWAP_REMOVED) && has_item(s, SMC_SWAP_WINDOW, "roll(p, 4)", SMC_SWAP_KEPT));
    CHECK(has_item(s, SMC_SWAP_WINDOW, "roll(p, 9)", SMC_SWAP_ADDED) && has_item(s, SMC_SWAP_WINDOW, "roll(p, 7)", SMC_SWAP_REMOVED));
    CHECK(smc_swap_item_kind(s, 10) == -1 && smc_swap_item_fate(s, 10) == -1 && is_text(smc_swap_item_name(s, 10), ""));
    CHECK(smc_swap_compare(s, from, third) == SMC_E_REFUSED && strstr(smc_error_text(s), "layouts") != NULL && smc_swap_item_count(s) == 10);
    CHECK(smc_swap_compare(s, from, from) == SMC_E_ARGUMENT && smc_swap_compare(s, 0, to) == SMC_E_HANDLE && smc_swap_compare(NULL, from, to) == SMC_E_HANDLE);
    CHECK(smc_machine_step(s, from, 1) == SMC_OK && smc_swap_compare(s, to, from) == SMC_OK && has_item(s, SMC_SWAP_STATE, "First", SMC_SWAP_REMOVED));
    CHECK(smc_machine_continue(s, from, to) == SMC_OK && has_item(s, SMC_SWAP_STATE, "First", SMC_SWAP_ADDED) && get_number(s, to, "n") == 1 && get_number(s, to, "k") == 2);
    CHECK(smc_machine_close(s, from) == SMC_OK && smc_machine_close(s, to) == SMC_OK && has_item(s, SMC_SWAP_LOCAL, "old", SMC_SWAP_REMOVED));
    for (int32_t fate = SMC_SWAP_KEPT; fate <= SMC_SWAP_CHANGED; fate++)
        CHECK(smc_swap_fate_text(fate)[0] != '\0');
    CHECK(is_text(smc_swap_fate_text(-1), "") && is_text(smc_swap_fate_text(4), "") && smc_swap_item_count(NULL) == 0);
    smc_close(s);
}

static void test_continuing(void)
{
    SmcSession *s = open_session();
    static const char newer[] = "[state_vector]\nU64 G\nU32 S\nF32 p\nbool valve\nI16 small\n[local]\nU8 n = 9\n[First]\n[Fill] @safe\n.step\n    n = n + 2\n    small = n\n    valve = p > 1\n";
    static const char vector[] = "[Bus]\nU64 G\nU32 S\nF32 p @range 0 1000\nbool valve\nI16 small\n";
    const uint32_t a = add(s, SMC_KIND_SM, "a.sm", tank), b = add(s, SMC_KIND_SM, "b.sm", newer);
    uint32_t bus;
    SmcMachine old, new, other;

    CHECK(smc_option_set(s, SMC_OPTION_WARNINGS, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_machine_open(s, b, &other) == SMC_OK);
    bus = add(s, SMC_KIND_SV, "bus.sv", vector);
    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, a, &old) == SMC_OK && smc_machine_open(s, b, &new) == SMC_OK && smc_machine_open(s, bus, &other) == SMC_E_INDEX);
    CHECK(smc_machine_step(s, old, 10) == SMC_OK && smc_machine_step(s, old, 20) == SMC_OK);
    CHECK(smc_machine_continue(s, old, other) == SMC_E_REFUSED && strstr(smc_error_text(s), "layouts") != NULL);
    CHECK(smc_machine_continue(s, old, old) == SMC_E_ARGUMENT && smc_machine_continue(s, old, 5) == SMC_E_HANDLE);
    CHECK(smc_machine_continue(s, old, new) == SMC_OK && smc_machine_state(s, new) == 2 && get_number(s, new, "n") == 5 && smc_machine_time(s, new) == 10);
    CHECK(smc_machine_step(s, new, 20) == SMC_E_REFUSED && smc_machine_step(s, new, 30) == SMC_OK && get_number(s, new, "n") == 7 && get_number(s, old, "n") == 5);
    CHECK(smc_machine_set(s, old, find_element(s, old, "p"), 950) == SMC_OK && smc_machine_step(s, old, 30) == SMC_OK && smc_machine_continue(s, old, new) == SMC_E_REFUSED);
    smc_close(s);
}

// A parameter can be set before the first step, within its range, and cannot be a column of inputs.
static void test_setting_parameters(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "deploy.sm", "[state_vector]\nU64 G\nU32 S\nF64 x\n[local]\nF64 limit = 450 @parameter @range 150 1000\n"
                                                         "U8 n = 3 @parameter @range 1 9\n[A]\n.step\nx = limit + n\n");
    const double nan = (double)NAN, values[2] = {200, 300}, *column[1] = {values};
    const uint64_t g[2] = {5, 6};
    SmcMachine m = 0;
    uint64_t done;
    uint8_t byte = 12;
    uint32_t limit, n;

    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, sm, &m) == SMC_OK);
    limit = find_element(s, m, "limit");
    n = find_element(s, m, "n");
    CHECK(smc_machine_variable_kind(s, m, limit) == SMC_VARIABLE_LOCAL && get_number(s, m, "limit") == 450);
    CHECK(smc_machine_set(s, m, limit, 149) == SMC_E_ARGUMENT && is_text(smc_error_text(s), "the value is below the range"));
    CHECK(smc_machine_set(s, m, limit, 1001) == SMC_E_ARGUMENT && is_text(smc_error_text(s), "the value is above the range"));
    CHECK(smc_machine_set(s, m, n, 2.5) == SMC_E_ARGUMENT && is_text(smc_error_text(s), "the value of an integer must be a whole number"));
    CHECK(smc_machine_write(s, m, limit, &nan, sizeof nan) == SMC_E_ARGUMENT && is_text(smc_error_text(s), "the value is not a number"));
    CHECK(smc_machine_write(s, m, n, &byte, 1) == SMC_E_ARGUMENT && get_number(s, m, "n") == 3 && get_number(s, m, "limit") == 450);
    byte = 9;
    CHECK(smc_machine_set(s, m, limit, 300) == SMC_OK && smc_machine_write(s, m, n, &byte, 1) == SMC_OK);
    CHECK(smc_machine_run(s, m, 2, g, 1, &limit, column, 0, NULL, NULL, NULL, &done) == SMC_E_ARGUMENT && done == 0);
    CHECK(smc_machine_step(s, m, 10) == SMC_OK && get_number(s, m, "x") == 309);
    CHECK(smc_machine_set(s, m, limit, 300) == SMC_E_ARGUMENT && smc_machine_step(s, m, 20) == SMC_OK && get_number(s, m, "limit") == 300);
    CHECK(smc_machine_start(s, m, 1) == SMC_OK && get_number(s, m, "limit") == 450 && smc_machine_set(s, m, limit, 1000) == SMC_OK);
    CHECK(smc_close(s) == SMC_OK);
}

int main(void)
{
    test_running_machines();
    test_setting_parameters();
    test_running_columns();
    test_wrong_columns_are_refused();
    test_opening_images();
    test_opening_each_machine();
    test_swap_items_are_listed();
    test_continuing();
    return test_end("machines");
}
