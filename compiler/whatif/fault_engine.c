// SPDX-License-Identifier: Apache-2.0
#include "compiler/whatif/fault_engine.h"

#include <string.h>

#include "compiler/script/ref.h"

const char *const fault_kind_name[] = {
#define KIND(constant, name, sentence) name,
#include "compiler/whatif/fault_kinds.def"
#undef KIND
};
const char *const fault_kind_sentence[] = {
#define KIND(constant, name, sentence) sentence,
#include "compiler/whatif/fault_kinds.def"
#undef KIND
};

typedef struct Sensor {
    uint64_t now, last;       // true values in this step and in the previous one, as cells
    uint64_t *past;           // true values of the last `late` steps, a ring buffer
} Sensor;

struct FaultEngine {
    Engine engine;
    Engine *inner;
    const FaultInput *input;
    Sensor *sensor;           // by index in `input`: the true values of the input
    uint32_t inputs;
    uint32_t *input_of;       // by Var.index: 1 + index in `input`; 0: the variable is no input
    FaultSizes sizes;
    uint64_t step;            // number of the last step, from 1
    Fault fault[FAULTS_MOST];
    uint32_t faults;
    uint64_t begin;           // the first step in which the faults are active
    uint64_t held[FAULTS_MOST];       // by fault: the last reading before the fault began
    ScriptRandom call[FAULTS_MOST];   // by fault: the noise of its readings
    ScriptRandoms calls;      // `call` as a list; random.first gives the calls numbers after those of the script's calls
    RefRandom random;
    bool differs;             // some reading has differed from the true value
    EngineWrite *write;       // buffer for the writes of a step
    uint32_t room;            // capacity of `write`
    uint64_t *outside;        // by Var.index: the cells that scripts read, with the true values of inputs
    Arena *arena;
};

// ---- the readings ----

static double range_part(const FaultInput *in, double part) { return (in->hi - in->lo) * part; }

// Returns what a faulty sensor reads in this step, as a cell.
static uint64_t read_faulty(FaultEngine *e, uint32_t i)
{
    const FaultInput *in = &e->input[e->fault[i].input];
    const Sensor *s = &e->sensor[e->fault[i].input];
    const SmType type = in->var->type;
    const double x = ref_read(type, s->now);

    switch (e->fault[i].kind) {
    case FAULT_STUCK: return e->held[i];
    case FAULT_DEAD: return 0;
    case FAULT_NAN: return type == SM_F32 ? UINT64_C(0x7fc00000) : UINT64_C(0x7ff8000000000000);
    case FAULT_LOW: return ref_convert(type, in->lo);
    case FAULT_HIGH: return ref_convert(type, type == SM_BOOL ? 1 : in->hi);
    case FAULT_BELOW: return ref_convert(type, x - range_part(in, e->sizes.offset));
    case FAULT_ABOVE: return ref_convert(type, x + range_part(in, e->sizes.offset));
    case FAULT_NOISY: return ref_convert(type, x + ref_random_value(&e->random, i));
    case FAULT_LATE: return s->past[(e->step - 1) % e->sizes.late];
    case FAULT_DROPPED: return e->step - e->begin < e->sizes.dropped ? e->held[i] : s->now;
    case FAULT_FLIPPED: return !ref_true(x);
    case FAULT_KIND_COUNT: break;
    }
    return s->now;
}

// Stores the true values of a step before it runs.  The values before the first step are assumed to be those of the first step.
static void take_true_values(FaultEngine *e, const EngineWrite *write, uint32_t n)
{
    for (uint32_t i = 0; i < e->inputs; i++)
        e->sensor[i].last = e->sensor[i].now;
    for (uint32_t i = 0; i < n; i++)
        if (e->input_of[write[i].var])
            e->sensor[e->input_of[write[i].var] - 1].now = write[i].cell;
    for (uint32_t i = 0; i < e->faults && e->step == 1; i++)
        e->held[i] = e->sensor[e->fault[i].input].now;
    for (uint32_t i = 0; i < e->inputs && e->step == 1; i++) {
        e->sensor[i].last = e->sensor[i].now;
        for (uint32_t k = 0; k < e->sizes.late; k++)
            e->sensor[i].past[k] = e->sensor[i].now;
    }
}

// Stores the true values of this step in the ring buffers that late sensors read.
static void store_for_late_sensors(FaultEngine *e)
{
    for (uint32_t i = 0; i < e->inputs; i++)
        e->sensor[i].past[(e->step - 1) % e->sizes.late] = e->sensor[i].now;
}

// ---- the engine ----

static void reserve_writes(FaultEngine *e, uint32_t n)
{
    if (n + FAULTS_MOST <= e->room)
        return;
    e->room = 2 * (n + FAULTS_MOST);
    e->write = ARENA_ARRAY(e->arena, EngineWrite, e->room);
}

// Appends the readings of the faulty sensors to the n writes of a step.  Returns the new number of writes.
static uint32_t add_readings(FaultEngine *e, uint32_t n)
{
    for (uint32_t i = 0; i < e->faults; i++) {
        const uint64_t reading = read_faulty(e, i);
        e->differs |= reading != e->sensor[e->fault[i].input].now;
        e->write[n++] = (EngineWrite){e->input[e->fault[i].input].var->index, reading};
    }
    return n;
}

// Sets the cells that the script reads.  If the machine itself stored an input, the stored value becomes the true value.
static void set_outside_cells(FaultEngine *e, EngineStep *out)
{
    memcpy(e->outside, out->cell, e->engine.program->var.n * sizeof *e->outside);
    for (uint32_t i = 0; i < e->inputs; i++) {
        const uint32_t var = e->input[i].var->index;
        if (out->stored[var])
            e->sensor[i].now = out->cell[var];
        e->outside[var] = e->sensor[i].now;
    }
    out->outside = e->outside;
}

// Runs a step with the readings of the faulty sensors in place of the true values.
static EngineStatus faulty_step(Engine *engine, const EngineWrite *write, uint32_t n, EngineStep *out)
{
    FaultEngine *e = engine->self;
    EngineStatus status;

    e->step++;
    e->random.step = e->step;
    take_true_values(e, write, n);
    reserve_writes(e, n);
    if (n)
        memcpy(e->write, write, n * sizeof *write);
    n = add_readings(e, n);
    store_for_late_sensors(e);
    status = e->inner->step(e->inner, e->write, n, out);
    e->engine.error = e->inner->error;
    set_outside_cells(e, out);
    return status;
}

static EngineStatus faulty_init(Engine *engine, uint32_t state, EngineStep *out)
{
    FaultEngine *e = engine->self;
    const EngineStatus status = e->inner->init(e->inner, state, out);

    e->engine.error = e->inner->error;
    e->step = 0;
    e->faults = 0;
    e->differs = false;
    for (uint32_t i = 0; status == ENGINE_OK && i < e->inputs; i++)
        e->sensor[i].now = out->cell[e->input[i].var->index];
    return status;
}

static void faulty_close(Engine *engine) { (void)engine; }    // the inner engine is the caller's

FaultEngine *fault_engine_open(Arena *arena, Engine *inner, const FaultInput *input, uint32_t inputs, const FaultSizes *sizes, uint32_t calls)
{
    FaultEngine *e = ARENA_NEW(arena, FaultEngine);

    e->arena = arena;
    e->engine = (Engine){"faulty", inner->program, NULL, e, faulty_init, faulty_step, faulty_close, inner};
    e->inner = inner;
    e->input = input;
    e->inputs = inputs;
    e->sizes = *sizes;
    e->sensor = ARENA_ARRAY(arena, Sensor, inputs);
    e->input_of = ARENA_ARRAY(arena, uint32_t, inner->program->var.n);
    for (uint32_t i = 0; i < inputs; i++) {
        e->input_of[input[i].var->index] = i + 1;
        e->sensor[i].past = ARENA_ARRAY(arena, uint64_t, sizes->late);
    }
    e->outside = ARENA_ARRAY(arena, uint64_t, inner->program->var.n);
    e->calls.at = e->call;
    e->calls.n = FAULTS_MOST;
    ref_random_init(&e->random, arena, &e->calls, sizes->seed);
    e->random.first = calls;
    return e;
}

Engine *fault_engine(FaultEngine *e) { return &e->engine; }

void fault_engine_begin(FaultEngine *e, const Fault *fault, uint32_t n)
{
    e->begin = e->step + 1;
    e->faults = n;
    for (uint32_t i = 0; i < n; i++) {
        e->fault[i] = fault[i];
        e->held[i] = e->sensor[fault[i].input].now;
        e->call[i] = (ScriptRandom){.is_noise = true, .a = range_part(&e->input[fault[i].input], e->sizes.noise)};
    }
}

bool fault_engine_differs(const FaultEngine *e) { return e->differs; }

uint64_t fault_engine_true_cell(const FaultEngine *e, uint32_t input) { return e->sensor[input].now; }

const uint64_t *fault_engine_outside(const FaultEngine *e) { return e->outside; }
