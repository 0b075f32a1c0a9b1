// SPDX-License-Identifier: Apache-2.0
// Whole flights of the example machines as tasks of the runtime.  After every step, every element and T must equal those of the script engine.
//     flights IMAGE TRACE…      TRACE as `smc test --trace --trace-format=exact` writes it; its name begins with that of the machine
// Each flight is run six times: emitted, from the image, and from its decoded form; each of them in place and guarded.  The events must be the
// same each time, and must agree with S.
#include <stdlib.h>
#include <string.h>

#include "airbrakes.h"
#include "bytecode-vm/target/machine.h"
#include "mission.h"
#include "rocket.h"
#include "runtime-c/machine.h"
#include "runtime-c/psl/sim/sim.h"
#include "tests/test.h"

enum { LINES = 400000, NAMES = 20, WAYS = 6, TOLD = 64 };

// ---- traces: lines of `step name value` ----

typedef struct Line { uint32_t step; uint8_t name; double value; } Line;

static Line line[LINES];
static size_t lines;
static char name[NAMES][40];
static uint8_t names;

static uint8_t name_number(const char *text)
{
    for (uint8_t i = 0; i < names; i++)
        if (strcmp(name[i], text) == 0)
            return i;
    strcpy(name[names], text);
    return names++;
}

static bool read_trace(const char *path)
{
    FILE *f = fopen(path, "r");
    unsigned long step;
    char what[40], value[80];

    lines = names = 0;
    while (f != NULL && lines < LINES && names < NAMES && fscanf(f, "%lu %39s %79s", &step, what, value) == 3) {
        line[lines].step = (uint32_t)step;
        line[lines].name = name_number(what);
        line[lines++].value = strcmp(value, "true") == 0 ? 1 : strtod(value, NULL);
    }
    return f != NULL && fclose(f) == 0 && lines > 1000 && lines < LINES;
}

// ---- the machines ----

typedef struct Subject {
    const char *name, *state;                 // state: the name of the element that is S
    const SmMachineType *type;
    void *self;
    uint32_t number;                          // number of the machine in the image
    const char *output[3];                    // the elements that it stores; all others are inputs
} Subject;

static Mission mission;
static Airbrakes airbrakes;
static const Subject subject[] = {
    {"mission", "missionState", &mission_machine, &mission, 0, {"missionState", "mayBrake", "deployParachutes"}},
    {"airbrakes", "airbrakeState", &airbrakes_machine, &airbrakes, 1, {"airbrakeState", "brakeOrder", ""}},
};

static uint8_t image[20000];
static uint32_t image_size;
static uint64_t memory[2000], decoded[4000], copy[sizeof(RocketSv) / 8];

static SmStateVec vector;
static SmEvent ring[TOLD];
static SmEvents events;
static SmvmTarget target;
static SmMachine machine;

static void set_up(const Subject *s, int way)
{
    const bool guarded = way % 2 != 0, emitted = way / 2 == 0;

    sim_reset();
    memset(&rocket_sv, 0, sizeof rocket_sv);
    vector = rocket_vector;
    vector.guarded = guarded;
    events = (SmEvents){.at = ring, .room = TOLD};
    target = (SmvmTarget){.image = image, .size = image_size, .machine = s->number, .memory = memory, .memory_size = sizeof memory,
        .decoder = way / 2 == 2 ? &smvm_decoder : NULL, .decoded = decoded, .decoded_size = sizeof decoded};
    machine = (SmMachine){.name = s->name, .type = emitted ? s->type : &smvm_machine_type, .self = emitted ? s->self : &target,
        .sv = &vector, .events = &events, .copy = guarded ? copy : NULL};
    CHECK(sm_statevec_init(&vector) == SM_OK && sm_events_init(&events) == SM_OK && sm_machine_init(&machine) == SM_OK);
}

// ---- a flight ----

// Finds the element of each name of the trace; NULL: T, or a local.
static const SmElement *element[NAMES];
static bool output[NAMES];

static void find_elements(const Subject *s)
{
    for (uint8_t i = 0; i < names; i++) {
        const char *n = strcmp(name[i], "G") == 0 ? "time" : strcmp(name[i], "S") == 0 ? s->state : name[i];
        element[i] = sm_find_element(&rocket_names, n);
        output[i] = strcmp(n, s->output[0]) == 0 || strcmp(n, s->output[1]) == 0 || strcmp(n, s->output[2]) == 0;
    }
}

static void write_inputs(const Line *from, const Line *to)
{
    for (; from < to; from++)
        if (element[from->name] != NULL && !output[from->name])
            CHECK(sm_write_number(&vector, element[from->name], from->value) == SM_OK);
}

static void check_results(const Line *from, const Line *to)
{
    double value = 0;

    for (; from < to; from++) {
        if (strcmp(name[from->name], "T") == 0)
            CHECK((double)sm_machine_time(&machine) == from->value);
        if (element[from->name] != NULL)
            CHECK(sm_read_number(&vector, element[from->name], &value) == SM_OK && value == from->value);
    }
}

// The events have the same sequence of states as S.
static void check_events(uint32_t last, uint32_t *told)
{
    SmEvent e = {.b = 0};
    uint32_t state = 0;

    while (sm_events_read(&events, told, &e, 1, NULL) == 1) {
        CHECK(e.kind == SM_EVENT_STATE && e.a == state && e.b != e.a);
        state = e.b;
    }
    CHECK(state == last || *told == 0);
}

static uint32_t fly(const Subject *s, int way)
{
    SmTick tick = {0, 0};
    uint32_t told = 0;
    size_t from = 0, to;

    set_up(s, way);
    for (; from < lines; from = to) {
        for (to = from; to < lines && line[to].step == line[from].step; to++)
            ;
        write_inputs(line + from, line + to);
        CHECK(sm_machine_step(&machine, &tick) == SM_OK);
        check_results(line + from, line + to);
        tick.time += 10000000;
        tick.number++;
    }
    check_events(sm_machine_state(&machine), &told);
    return told;
}

static bool same_events(const SmEvent *a, const SmEvent *b, uint32_t n)
{
    for (; n > 0; n--, a++, b++)
        if (a->time != b->time || a->a != b->a || a->b != b->b || a->source != b->source || a->kind != b->kind)
            return false;
    return true;
}

static void fly_all(const Subject *s)
{
    static SmEvent first[TOLD];
    uint32_t told;

    find_elements(s);
    told = fly(s, 0);
    CHECK(told > 0 && told < TOLD);
    memcpy(first, ring, sizeof first);
    for (int way = 1; way < WAYS; way++)
        CHECK(fly(s, way) == told && same_events(first, ring, told));
}

static bool read_image(const char *path)
{
    FILE *f = fopen(path, "rb");

    image_size = f != NULL ? (uint32_t)fread(image, 1, sizeof image, f) : 0;
    return f != NULL && fclose(f) == 0 && image_size > 0;
}

int main(int argc, char **argv)
{
    CHECK(argc > 2 && read_image(argv[1]));
    for (int i = 2; i < argc; i++) {
        const char *slash = strrchr(argv[i], '/'), *file = slash != NULL ? slash + 1 : argv[i];
        CHECK(read_trace(argv[i]));
        for (size_t k = 0; k < sizeof subject / sizeof *subject; k++)
            if (strncmp(file, subject[k].name, strlen(subject[k].name)) == 0)
                fly_all(&subject[k]);
    }
    return test_end("flights");
}
