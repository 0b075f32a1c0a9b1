// SPDX-License-Identifier: Apache-2.0
// smc.dll as LabVIEW uses it.  This program knows only docs/labview.md: page.h declares the functions by the prototypes of that page, as pointers, and
// LOAD_FUNCTIONS loads them.        labview DLL FOLDER (of the examples)
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <windows.h>

typedef char *CStr;
#include "page.h"

enum { MESSAGE = 256, BYTES = 60000 };

static char message[MESSAGE];
static uint8_t bytes[BYTES];
static int passed, failed;

#define MESSAGE_ARGUMENTS message, MESSAGE
#define CHECK(condition) check(condition, #condition, __LINE__)

static void check(int ok, const char *what, int line)
{
    if (ok) {
        passed++;
        return;
    }
    failed++;
    printf("line %d: not true: %s (message '%s')\n", line, what, message);
}

static char text[BYTES];

static int read_example(const char *folder, const char *name)
{
    char path[400];
    FILE *f;
    size_t n;

    snprintf(path, sizeof path, "%s/%s", folder, name);
    f = fopen(path, "rb");
    n = f ? fread(text, 1, sizeof text - 1, f) : 0;
    text[n] = '\0';
    if (f)
        fclose(f);
    return (int)n;
}

// Replaces the first `from` in the text by a `to` of the same length.
static void replace(const char *from, const char *to)
{
    char *at = strstr(text, from);

    CHECK(at != NULL && strlen(from) == strlen(to));
    if (at)
        memcpy(at, to, strlen(to));
}

static int32_t add_source(int32_t session, int32_t kind, const char *name, int32_t n)
{
    int32_t source = -1;

    CHECK(smclv_source(session, kind, (CStr)name, (uint8_t *)text, n, &source, MESSAGE_ARGUMENTS) == 0);
    return source;
}

static int32_t find(int32_t machine, const char *name)
{
    int32_t variable = -1;

    CHECK(smclv_find(machine, (CStr)name, &variable, MESSAGE_ARGUMENTS) == 0);
    return variable;
}

static double get(int32_t machine, int32_t variable)
{
    double value = -1;

    CHECK(smclv_get(machine, &variable, &value, 1, MESSAGE_ARGUMENTS) == 0);
    return value;
}

static void set(int32_t machine, const char *name, double value)
{
    int32_t variable = find(machine, name);

    CHECK(smclv_set(machine, &variable, &value, 1, MESSAGE_ARGUMENTS) == 0);
}

// Runs steps of 10 ms until `machine` is in another state, or `most` steps are over.  Returns the state.
static int32_t step_until_change(int32_t machine, uint64_t *g, int most)
{
    int32_t before = 0, state = 0;

    CHECK(smclv_machine_state(machine, &before, NULL, NULL, MESSAGE_ARGUMENTS) == 0);
    for (state = before; state == before && most > 0; most--)
        if (smclv_machine_step(machine, *g += 10, &state, MESSAGE_ARGUMENTS) != 0) {
            CHECK(!"a step was refused");
            break;
        }
    return state;
}

static int is_state(int32_t machine, int32_t state, const char *name)
{
    int32_t n = 0;

    CHECK(smclv_machine_state_name(machine, state, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0);
    return (size_t)n == strlen(name) && memcmp(bytes, name, (size_t)n) == 0;
}

static void try_diagnostics(int32_t session)
{
    static const char wrong[] = "[state_vector]\nU64 G\nU32 S\n[Idle]\n.step\n    x = 1\n";
    int32_t source, n = 0, short_n = 0;

    strcpy(text, wrong);
    source = add_source(session, 1, "wrong.sm", (int32_t)strlen(wrong));
    CHECK(smclv_compile(session, bytes, BYTES - 1, &n, MESSAGE_ARGUMENTS) == -5);
    CHECK(message[0] != '\0' && n > 20);
    bytes[n < BYTES ? n : 0] = '\0';
    CHECK(strstr((char *)bytes, "wrong.sm:6:5: error") != NULL);
    CHECK(smclv_machine_open(session, source, &n, MESSAGE_ARGUMENTS) == -4);
    CHECK(smclv_compile(session, bytes, 10, &short_n, message, 5) == -5 && strlen(message) == 4);
    CHECK(smclv_clear(session, MESSAGE_ARGUMENTS) == 0);
}

// Compiles the tank, runs its script, steps it, and swaps it for a tank with another limit while it runs.
static void try_tank(int32_t session, const char *folder)
{
    int32_t size = read_example(folder, "tank/tank.sm"), n = 0, old, changed, state = 0, states = 0, variables[2];
    const int32_t source = add_source(session, 1, "tank.sm", size);
    int32_t script;
    uint64_t g = 0, time = 0, cells[2];
    double value = 700;

    size = read_example(folder, "tank/tank.ss");
    script = add_source(session, 2, "tank.ss", size);
    CHECK(smclv_compile(session, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0 && n == 0 && message[0] == '\0');
    CHECK(smclv_run(session, script, 0, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0 && n > 0);
    CHECK(smclv_diagram(session, source, 0, bytes, 10, &n, MESSAGE_ARGUMENTS) == -7 && n > 1000);
    CHECK(smclv_diagram(session, source, 0, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0 && memcmp(bytes, "<svg", 4) == 0);
    CHECK(smclv_machine_open(session, source, &old, MESSAGE_ARGUMENTS) == 0 && old > 0);
    set(old, "tankPressure", 780);
    CHECK(smclv_machine_step(old, g += 10, &state, MESSAGE_ARGUMENTS) == 0 && state == 1);
    CHECK(get(old, find(old, "valveOpen")) == 1 && get(old, find(old, "counter")) == 1);
    CHECK(smclv_machine_step(old, g, &state, MESSAGE_ARGUMENTS) == -9 && message[0] != '\0');

    size = read_example(folder, "tank/tank.sm");
    replace("tankPressure > 775", "tankPressure > 795");
    CHECK(add_source(session, 1, "tank.sm", size) == source);
    CHECK(smclv_compile(session, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0);
    CHECK(smclv_machine_open(session, source, &changed, MESSAGE_ARGUMENTS) == 0 && changed != old);
    CHECK(smclv_machine_continue(old, changed, MESSAGE_ARGUMENTS) == 0);
    CHECK(get(changed, find(changed, "counter")) == 1);
    CHECK(smclv_machine_state(changed, &state, &states, &time, MESSAGE_ARGUMENTS) == 0 && state == 1 && states == 3);
    CHECK(smclv_machine_close(old, MESSAGE_ARGUMENTS) == 0 && smclv_machine_step(old, 1000, &state, MESSAGE_ARGUMENTS) == -2);
    CHECK(smclv_machine_step(changed, g += 10, &state, MESSAGE_ARGUMENTS) == 0);
    CHECK(get(changed, find(changed, "valveOpen")) == 0);

    variables[0] = find(changed, "counter");
    variables[1] = find(changed, "tankPressure");
    cells[0] = 9007199254740993u;
    memcpy(&cells[1], &value, sizeof value);
    CHECK(smclv_set_cells(changed, variables, cells, 2, MESSAGE_ARGUMENTS) == 0);
    cells[0] = cells[1] = 0;
    CHECK(smclv_get_cells(changed, variables, cells, 2, MESSAGE_ARGUMENTS) == 0 && cells[0] == 9007199254740993u);
    CHECK(get(changed, variables[1]) == 700);
    variables[0] = find(changed, "valveOpen");
    cells[0] = 256;
    CHECK(smclv_set_cells(changed, variables, cells, 1, MESSAGE_ARGUMENTS) == -7);
    set(changed, "tankPressure", 900);
    CHECK(is_state(changed, step_until_change(changed, &g, 5), "Abort"));
    CHECK(smclv_clear(session, MESSAGE_ARGUMENTS) == 0);
}

// Fires the engine of the ignition example, and runs it once more from its image.
static void try_ignition(int32_t session, const char *folder)
{
    int32_t size = read_example(folder, "ignition/ignition.sm"), n = 0, machine, from_image, count = 0, type = 0, kind = 0;
    const int32_t source = add_source(session, 1, "ignition.sm", size);
    uint64_t g = 0;

    CHECK(smclv_option(session, 1, 10, MESSAGE_ARGUMENTS) == 0);
    CHECK(smclv_compile(session, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0);
    CHECK(smclv_machine_open(session, source, &machine, MESSAGE_ARGUMENTS) == 0);
    set(machine, "fire", 1);
    CHECK(is_state(machine, step_until_change(machine, &g, 5), "Purge"));
    CHECK(is_state(machine, step_until_change(machine, &g, 200), "Ignite"));
    set(machine, "igniterLit", 1);
    CHECK(is_state(machine, step_until_change(machine, &g, 200), "Start"));
    set(machine, "pressureA", 20);
    set(machine, "pressureB", 20);
    set(machine, "pressureC", 20);
    CHECK(is_state(machine, step_until_change(machine, &g, 50), "Burn"));
    CHECK(get(machine, find(machine, "fuelValve")) == 1);
    set(machine, "fire", 0);
    CHECK(!is_state(machine, step_until_change(machine, &g, 50), "Burn"));

    CHECK(smclv_image(session, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == 0 && n > 100);
    CHECK(smclv_machine_open_image(session, bytes, n, 0, &from_image, MESSAGE_ARGUMENTS) == 0);
    CHECK(smclv_variables(from_image, &count, MESSAGE_ARGUMENTS) == 0 && count > 10);
    CHECK(smclv_variable(from_image, find(from_image, "pressureA"), bytes, BYTES, &n, &type, &kind, MESSAGE_ARGUMENTS) == 0);
    CHECK(type == 8 && kind == 0 && n == 9 && memcmp(bytes, "pressureA", 9) == 0);
    CHECK(smclv_machine_start(from_image, 2, MESSAGE_ARGUMENTS) == 0 && smclv_machine_start(from_image, 99, MESSAGE_ARGUMENTS) == -6);
    CHECK(is_state(from_image, 2, "Purge"));
    bytes[0] ^= 1;
    CHECK(smclv_machine_open_image(session, bytes, 9, 0, &n, MESSAGE_ARGUMENTS) == -8);
}

// Every function refuses invalid handles, pointers and lengths with a message.
static void try_wrong_arguments(int32_t session)
{
    const int32_t wrong[] = {0, -1, 1, 0x7FFFFFFF, session};
    int32_t n, x = 0;
    double d;
    uint64_t u;

    for (int i = 0; i < 5; i++) {
        const int32_t h = wrong[i];
        message[0] = '\0';
        if (h != session) {
            CHECK(smclv_close(h, MESSAGE_ARGUMENTS) == -2 && message[0] != '\0');
            CHECK(smclv_compile(h, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == -2 && smclv_clear(h, MESSAGE_ARGUMENTS) == -2);
            CHECK(smclv_option(h, 0, 1, MESSAGE_ARGUMENTS) == -2 && smclv_image(h, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == -2);
            CHECK(smclv_source(h, 1, "a.sm", bytes, 0, &n, MESSAGE_ARGUMENTS) == -2 && smclv_run(h, 0, 0, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == -2);
            CHECK(smclv_diagram(h, 0, 0, bytes, BYTES, &n, MESSAGE_ARGUMENTS) == -2 && smclv_machine_open(h, 0, &n, MESSAGE_ARGUMENTS) == -2);
            CHECK(smclv_machine_open_image(h, bytes, BYTES, 0, &n, MESSAGE_ARGUMENTS) == -2);
        }
        CHECK(smclv_machine_close(h, MESSAGE_ARGUMENTS) == -2 && smclv_machine_start(h, 1, MESSAGE_ARGUMENTS) == -2);
        CHECK(smclv_machine_step(h, 1, &n, MESSAGE_ARGUMENTS) == -2 && smclv_machine_continue(h, h, MESSAGE_ARGUMENTS) == -2);
        CHECK(smclv_machine_state(h, &n, &n, &u, MESSAGE_ARGUMENTS) == -2 && smclv_machine_state_name(h, 1, bytes, 1, &n, MESSAGE_ARGUMENTS) == -2);
        CHECK(smclv_variables(h, &n, MESSAGE_ARGUMENTS) == -2 && smclv_variable(h, 0, bytes, 1, &n, &n, &n, MESSAGE_ARGUMENTS) == -2);
        CHECK(smclv_find(h, "x", &n, MESSAGE_ARGUMENTS) == -2 && smclv_get(h, &x, &d, 1, MESSAGE_ARGUMENTS) == -2);
        CHECK(smclv_set(h, &x, &d, 1, MESSAGE_ARGUMENTS) == -2 && smclv_get_cells(h, &x, &u, 1, MESSAGE_ARGUMENTS) == -2);
        CHECK(smclv_set_cells(h, &x, &u, 1, MESSAGE_ARGUMENTS) == -2);
    }
    CHECK(smclv_open(NULL, MESSAGE_ARGUMENTS) == -1 && smclv_compile(session, NULL, 0, NULL, NULL, 0) != -2);
    CHECK(smclv_source(session, 1, NULL, bytes, 1, &n, MESSAGE_ARGUMENTS) == -1 && smclv_source(session, 1, "a.sm", bytes, -1, &n, MESSAGE_ARGUMENTS) == -1);
}

// 64 sessions can be open, and a handle is not used again after its session was closed.
static void try_handles(void)
{
    int32_t handle[64], more = 0, again = 0, n = 0;

    for (n = 0; n < 64 && smclv_open(&handle[n], MESSAGE_ARGUMENTS) == 0; n++)
        continue;
    CHECK(n == 64 && smclv_open(&more, MESSAGE_ARGUMENTS) == -3);
    CHECK(n == 64 && smclv_close(handle[0], MESSAGE_ARGUMENTS) == 0 && smclv_open(&again, MESSAGE_ARGUMENTS) == 0 && again != handle[0]);
    CHECK(smclv_clear(handle[0], MESSAGE_ARGUMENTS) == -2);
    handle[0] = again;
    while (n > 0)
        CHECK(smclv_close(handle[--n], MESSAGE_ARGUMENTS) == 0);
}

int main(int argc, char **argv)
{
    const HMODULE dll = argc == 3 ? LoadLibraryA(argv[1]) : NULL;
    int32_t session = 0;

    if (!dll) {
        puts("the DLL does not load: 0 passed, 1 failed");
        return 1;
    }
    LOAD_FUNCTIONS(dll);
    CHECK(smclv_open(&session, MESSAGE_ARGUMENTS) == 0 && session > 0);
    try_diagnostics(session);
    try_tank(session, argv[2]);
    try_ignition(session, argv[2]);
    try_wrong_arguments(session);
    CHECK(smclv_close(session, MESSAGE_ARGUMENTS) == 0 && smclv_close(session, MESSAGE_ARGUMENTS) == -2);
    try_handles();
    FreeLibrary(dll);
    printf("labview: %d passed, %d failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
