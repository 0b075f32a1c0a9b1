// SPDX-License-Identifier: Apache-2.0
// Handles, texts and values of labview.h.  Everything else is libsmc, of which only the public functions are called.
#include "compiler/labview/labview.h"
#include "compiler/library/smc.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

// ---- handles ----

// A handle is a slot, how often the slot was used, and a bit of machines: handles of what was closed or of another kind are refused.
enum { SESSIONS_MOST = 64, MACHINES_MOST = 1024, SLOT_BITS = 10, USES_MOST = 0xFFFFF, OF_MACHINE = 1 << 30 };

typedef struct Slot {
    uint32_t uses;
    bool is_open;
    bool is_busy;             // for a session: a call has not returned yet
    SmcSession *session;
    SmcMachine machine;       // for a machine
    int32_t owner;            // for a machine: the handle of its session
} Slot;

static Slot sessions[SESSIONS_MOST], machines[MACHINES_MOST];
static volatile int lock;     // protects both tables; it is locked only for a few instructions

static void take_lock(void)
{
    while (__sync_lock_test_and_set(&lock, 1))
        continue;
}
static void release_lock(void) { __sync_lock_release(&lock); }

static int32_t handle_of(const Slot *table, const Slot *slot)
{
    return (int32_t)(slot->uses << SLOT_BITS | (uint32_t)(slot - table)) | (table == machines ? OF_MACHINE : 0);
}

// Returns the open slot of a handle, or NULL.  The caller holds the lock.
static Slot *find_slot(Slot *table, uint32_t most, int32_t handle)
{
    const uint32_t at = (uint32_t)handle & ((1u << SLOT_BITS) - 1);

    return handle > 0 && at < most && table[at].is_open && handle_of(table, &table[at]) == handle ? &table[at] : NULL;
}

// Returns a slot that is now in use, or NULL.  The caller holds the lock.
static Slot *use_slot(Slot *table, uint32_t most)
{
    for (uint32_t i = 0; i < most; i++)
        if (!table[i].is_open) {
            table[i].is_open = true;
            table[i].is_busy = false;
            table[i].uses = table[i].uses % USES_MOST + 1;
            return &table[i];
        }
    return NULL;
}

// ---- calls ----

// A call in progress.
typedef struct Call {
    Slot *of;                 // the slot of the session; NULL: the handle has no session
    SmcSession *s;
    SmcMachine m;
    char *message;
    int32_t message_size;
} Call;

static void copy_message(const Call *c, const char *text)
{
    size_t n = strlen(text);

    if (!c->message || c->message_size <= 0)
        return;
    if (n > (size_t)c->message_size - 1)
        n = (size_t)c->message_size - 1;
    memcpy(c->message, text, n);
    c->message[n] = '\0';
}

static int32_t refuse(const Call *c, SmcResult r)
{
    copy_message(c, smc_result_text(r));
    return r;
}

// Takes the session of a handle for this call.  The caller holds the lock.
static SmcResult take_session(Call *c, int32_t session)
{
    Slot *slot = find_slot(sessions, SESSIONS_MOST, session);

    if (!slot || slot->is_busy)
        return slot ? SMC_E_BUSY : SMC_E_HANDLE;
    slot->is_busy = true;
    c->of = slot;
    c->s = slot->session;
    return SMC_OK;
}

static SmcResult begin_call(Call *c, int32_t session, char *message, int32_t message_size)
{
    SmcResult r;

    *c = (Call){.message = message, .message_size = message_size};
    take_lock();
    r = take_session(c, session);
    release_lock();
    return r == SMC_OK ? r : refuse(c, r);
}

static SmcResult begin_machine(Call *c, int32_t machine, char *message, int32_t message_size)
{
    SmcResult r = SMC_E_HANDLE;
    Slot *slot;

    *c = (Call){.message = message, .message_size = message_size};
    take_lock();
    if ((slot = find_slot(machines, MACHINES_MOST, machine)) != NULL && (r = take_session(c, slot->owner)) == SMC_OK)
        c->m = slot->machine;
    release_lock();
    return r == SMC_OK ? r : refuse(c, r);
}

// Ends a call: stores its message, and lets the next call of the session begin.
static int32_t finish(const Call *c, SmcResult r)
{
    const char *text = r == SMC_OK ? "" : smc_error_text(c->s);

    copy_message(c, r != SMC_OK && !*text ? smc_result_text(r) : text);
    take_lock();
    c->of->is_busy = false;
    release_lock();
    return r;
}

// Ends the call like `finish`, with an error that libsmc did not report.
static int32_t finish_refused(const Call *c, SmcResult r)
{
    finish(c, SMC_OK);
    return refuse(c, r);
}

// Copies bytes into an array of the caller.  Returns `r`, or SMC_E_SIZE if the array is too short and r is SMC_OK.
static SmcResult copy_bytes(SmcResult r, const void *bytes, uint64_t n, uint8_t *into, int32_t size, int32_t *length)
{
    const uint64_t room = into && size > 0 ? (uint64_t)size : 0;

    if (n > INT32_MAX)
        return r == SMC_OK ? SMC_E_SIZE : r;
    if (room && n)
        memcpy(into, bytes, (size_t)(n < room ? n : room));
    if (length)
        *length = (int32_t)n;
    return r == SMC_OK && n > room ? SMC_E_SIZE : r;
}

static int32_t finish_copied(const Call *c, SmcResult of_call, SmcResult copied)
{
    return of_call == SMC_OK && copied != SMC_OK ? finish_refused(c, copied) : finish(c, of_call);
}

// ---- sessions ----

int32_t smclv_open(int32_t *session, char *message, int32_t message_size)
{
    const Call c = {.message = message, .message_size = message_size};
    SmcSession *s = NULL;
    Slot *slot = NULL;
    SmcResult r;

    if (!session)
        return refuse(&c, SMC_E_ARGUMENT);
    *session = 0;
    if ((r = smc_open(NULL, 0, &s)) != SMC_OK)
        return refuse(&c, r);
    take_lock();
    if ((slot = use_slot(sessions, SESSIONS_MOST)) != NULL) {
        slot->session = s;
        *session = handle_of(sessions, slot);
    }
    release_lock();
    if (!slot)
        smc_close(s);
    copy_message(&c, slot ? "" : "64 sessions are open; close one");
    return slot ? SMC_OK : SMC_E_MEMORY;
}

int32_t smclv_close(int32_t session, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size);

    if (r != SMC_OK)
        return r;
    smc_close(c.s);
    copy_message(&c, "");
    take_lock();
    for (int i = 0; i < MACHINES_MOST; i++)
        if (machines[i].is_open && machines[i].owner == session)
            machines[i].is_open = false;
    c.of->is_open = false;
    release_lock();
    return SMC_OK;
}

// Returns the number of the source of that name, or -1.
static int32_t find_source(const SmcSession *s, const char *name)
{
    const uint32_t n = smc_source_count(s);

    for (uint32_t i = 0; i < n; i++)
        if (strcmp(smc_source_name(s, i), name) == 0)
            return (int32_t)i;
    return -1;
}

int32_t smclv_source(int32_t session, int32_t kind, const char *name, const uint8_t *text, int32_t text_length, int32_t *source,
                     char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size);
    uint32_t number = 0;
    int32_t known;

    if (r != SMC_OK)
        return r;
    if (!name || !source || text_length < 0)
        return finish_refused(&c, SMC_E_ARGUMENT);
    known = find_source(c.s, name);
    if (known >= 0 && smc_source_kind(c.s, (uint32_t)known) != kind)
        return finish_refused(&c, SMC_E_ARGUMENT);
    if (known >= 0)
        r = smc_source_replace(c.s, number = (uint32_t)known, (const char *)text, (uint64_t)text_length);
    else
        r = smc_source_add(c.s, kind, name, (const char *)text, (uint64_t)text_length, &number);
    if (r == SMC_OK)
        *source = (int32_t)number;
    return finish(&c, r);
}

int32_t smclv_clear(int32_t session, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size);

    return r != SMC_OK ? r : finish(&c, smc_sources_clear(c.s));
}

int32_t smclv_option(int32_t session, int32_t option, uint64_t value, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size);

    return r != SMC_OK ? r : finish(&c, smc_option_set(c.s, option, value));
}

// ---- compiling ----

int32_t smclv_compile(int32_t session, uint8_t *diagnostics, int32_t size, int32_t *length, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size), copied;
    const char *text = "";
    uint64_t n = 0;

    if (r != SMC_OK)
        return r;
    r = smc_compile(c.s);
    copied = smc_render(c.s, SMC_RENDER_TEXT, &text, &n);
    if (copied == SMC_OK)
        copied = copy_bytes(SMC_OK, text, n, diagnostics, size, length);
    return finish_copied(&c, r, copied);
}

int32_t smclv_image(int32_t session, uint8_t *image, int32_t size, int32_t *length, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size), copied = SMC_OK;
    uint64_t names, n = 0;
    const void *bytes = NULL;

    if (r != SMC_OK)
        return r;
    names = smc_option(c.s, SMC_OPTION_NAMES);
    smc_option_set(c.s, SMC_OPTION_NAMES, 1);
    if ((r = smc_emit(c.s, SMC_EMIT_IMAGE)) == SMC_OK && (r = smc_output(c.s, 0, &bytes, &n)) == SMC_OK)
        copied = copy_bytes(SMC_OK, bytes, n, image, size, length);
    smc_option_set(c.s, SMC_OPTION_NAMES, names);
    return finish_copied(&c, r, copied);
}

int32_t smclv_run(int32_t session, int32_t script, uint64_t steps, uint8_t *report, int32_t size, int32_t *length, char *message,
                  int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size), copied;
    const char *text;

    if (r != SMC_OK)
        return r;
    r = smc_run(c.s, (uint32_t)script, SMC_ENGINE_VM, steps);
    text = smc_run_report(c.s, (uint32_t)script);
    copied = copy_bytes(SMC_OK, text, strlen(text), report, size, length);
    return finish_copied(&c, r, copied);
}

int32_t smclv_diagram(int32_t session, int32_t source, int32_t form, uint8_t *text, int32_t size, int32_t *length, char *message,
                      int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size), copied = SMC_OK;
    const char *drawn = "";
    uint64_t n = 0;

    if (r != SMC_OK)
        return r;
    if ((r = smc_diagram(c.s, (uint32_t)source, form, &drawn, &n)) == SMC_OK)
        copied = copy_bytes(SMC_OK, drawn, n, text, size, length);
    return finish_copied(&c, r, copied);
}

// ---- machines ----

// Stores the handle of a machine that libsmc has opened.
static int32_t add_machine(const Call *c, int32_t session, SmcMachine m, int32_t *machine)
{
    Slot *slot;

    take_lock();
    if ((slot = use_slot(machines, MACHINES_MOST)) != NULL) {
        slot->machine = m;
        slot->owner = session;
        *machine = handle_of(machines, slot);
    }
    release_lock();
    if (slot)
        return finish(c, SMC_OK);
    smc_machine_close(c->s, m);
    return finish_refused(c, SMC_E_MEMORY);
}

int32_t smclv_machine_open(int32_t session, int32_t source, int32_t *machine, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size);
    SmcMachine m = 0;

    if (r != SMC_OK)
        return r;
    if (!machine)
        return finish_refused(&c, SMC_E_ARGUMENT);
    *machine = 0;
    r = smc_machine_open(c.s, (uint32_t)source, &m);
    return r == SMC_OK ? add_machine(&c, session, m, machine) : finish(&c, r);
}

int32_t smclv_machine_open_image(int32_t session, const uint8_t *image, int32_t image_length, int32_t number, int32_t *machine, char *message,
                                 int32_t message_size)
{
    Call c;
    SmcResult r = begin_call(&c, session, message, message_size);
    SmcMachine m = 0;

    if (r != SMC_OK)
        return r;
    if (!machine || !image || image_length < 0)
        return finish_refused(&c, SMC_E_ARGUMENT);
    *machine = 0;
    r = smc_machine_open_image(c.s, image, (uint64_t)image_length, (uint32_t)number, &m);
    return r == SMC_OK ? add_machine(&c, session, m, machine) : finish(&c, r);
}

int32_t smclv_machine_close(int32_t machine, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);
    Slot *slot;

    if (r != SMC_OK)
        return r;
    take_lock();
    if ((slot = find_slot(machines, MACHINES_MOST, machine)) != NULL)
        slot->is_open = false;
    release_lock();
    return finish(&c, smc_machine_close(c.s, c.m));
}

int32_t smclv_machine_start(int32_t machine, int32_t state, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);

    return r != SMC_OK ? r : finish(&c, smc_machine_start(c.s, c.m, (uint32_t)state));
}

int32_t smclv_machine_step(int32_t machine, uint64_t g, int32_t *state, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);

    if (r != SMC_OK)
        return r;
    r = smc_machine_step(c.s, c.m, g);
    if (state)
        *state = (int32_t)smc_machine_state(c.s, c.m);
    return finish(&c, r);
}

int32_t smclv_machine_continue(int32_t from, int32_t to, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, from, message, message_size);
    SmcMachine target = 0;
    Slot *slot;

    if (r != SMC_OK)
        return r;
    take_lock();
    if ((slot = find_slot(machines, MACHINES_MOST, to)) != NULL && find_slot(sessions, SESSIONS_MOST, slot->owner) == c.of)
        target = slot->machine;
    release_lock();
    return target ? finish(&c, smc_machine_continue(c.s, c.m, target)) : finish_refused(&c, SMC_E_HANDLE);
}

int32_t smclv_machine_state(int32_t machine, int32_t *state, int32_t *states, uint64_t *time, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);

    if (r != SMC_OK)
        return r;
    if (state)
        *state = (int32_t)smc_machine_state(c.s, c.m);
    if (states)
        *states = (int32_t)smc_machine_state_count(c.s, c.m);
    if (time)
        *time = smc_machine_time(c.s, c.m);
    return finish(&c, SMC_OK);
}

int32_t smclv_machine_state_name(int32_t machine, int32_t state, uint8_t *name, int32_t size, int32_t *length, char *message,
                                 int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);
    const char *text;

    if (r != SMC_OK)
        return r;
    if (state < 1 || (uint32_t)state > smc_machine_state_count(c.s, c.m))
        return finish_refused(&c, SMC_E_INDEX);
    text = smc_machine_state_name(c.s, c.m, (uint32_t)state);
    return finish_copied(&c, SMC_OK, copy_bytes(SMC_OK, text, strlen(text), name, size, length));
}

// ---- variables ----

int32_t smclv_variables(int32_t machine, int32_t *count, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);

    if (r != SMC_OK)
        return r;
    if (!count)
        return finish_refused(&c, SMC_E_ARGUMENT);
    *count = (int32_t)smc_machine_variable_count(c.s, c.m);
    return finish(&c, SMC_OK);
}

int32_t smclv_variable(int32_t machine, int32_t variable, uint8_t *name, int32_t size, int32_t *length, int32_t *type, int32_t *kind,
                       char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);
    const char *text;

    if (r != SMC_OK)
        return r;
    if (smc_machine_variable_type(c.s, c.m, (uint32_t)variable) < 0)
        return finish_refused(&c, SMC_E_INDEX);
    if (type)
        *type = smc_machine_variable_type(c.s, c.m, (uint32_t)variable);
    if (kind)
        *kind = smc_machine_variable_kind(c.s, c.m, (uint32_t)variable);
    text = smc_machine_variable_name(c.s, c.m, (uint32_t)variable);
    return finish_copied(&c, SMC_OK, copy_bytes(SMC_OK, text, strlen(text), name, size, length));
}

int32_t smclv_find(int32_t machine, const char *name, int32_t *variable, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_machine(&c, machine, message, message_size);
    uint32_t number;

    if (r != SMC_OK)
        return r;
    if (!variable)
        return finish_refused(&c, SMC_E_ARGUMENT);
    if ((r = smc_machine_find(c.s, c.m, name, &number)) == SMC_OK)
        *variable = (int32_t)number;
    return finish(&c, r);
}

// Begins a call about `count` variables.
static SmcResult begin_values(Call *c, int32_t machine, const int32_t *variables, const void *values, int32_t count, char *message,
                              int32_t message_size)
{
    SmcResult r = begin_machine(c, machine, message, message_size);

    if (r == SMC_OK && (count < 0 || (count > 0 && (!variables || !values))))
        return finish_refused(c, SMC_E_ARGUMENT);
    return r;
}

int32_t smclv_get(int32_t machine, const int32_t *variables, double *values, int32_t count, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_values(&c, machine, variables, values, count, message, message_size);

    if (r != SMC_OK)
        return r;
    for (int32_t i = 0; r == SMC_OK && i < count; i++)
        r = smc_machine_get(c.s, c.m, (uint32_t)variables[i], &values[i]);
    return finish(&c, r);
}

int32_t smclv_set(int32_t machine, const int32_t *variables, const double *values, int32_t count, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_values(&c, machine, variables, values, count, message, message_size);

    if (r != SMC_OK)
        return r;
    for (int32_t i = 0; r == SMC_OK && i < count; i++)
        r = smc_machine_set(c.s, c.m, (uint32_t)variables[i], values[i]);
    return finish(&c, r);
}

static bool is_float(int32_t type) { return type == SMC_TYPE_F32 || type == SMC_TYPE_F64; }

static uint32_t size_of_type(int32_t type)
{
    static const uint8_t sizes[] = {1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 1};       // by SMC_TYPE_…
    return type >= 0 && type <= SMC_TYPE_BOOL ? sizes[type] : 0;
}

// Reads an integer of 1, 2, 4 or 8 bytes from memory in the byte order of the computer, and extends its sign if it has one.
static uint64_t read_integer(const void *value, int32_t type)
{
    switch (type) {
    case SMC_TYPE_I8: { int8_t v; memcpy(&v, value, sizeof v); return (uint64_t)(int64_t)v; }
    case SMC_TYPE_I16: { int16_t v; memcpy(&v, value, sizeof v); return (uint64_t)(int64_t)v; }
    case SMC_TYPE_I32: { int32_t v; memcpy(&v, value, sizeof v); return (uint64_t)(int64_t)v; }
    case SMC_TYPE_U8: case SMC_TYPE_BOOL: { uint8_t v; memcpy(&v, value, sizeof v); return v; }
    case SMC_TYPE_U16: { uint16_t v; memcpy(&v, value, sizeof v); return v; }
    case SMC_TYPE_U32: { uint32_t v; memcpy(&v, value, sizeof v); return v; }
    default: { uint64_t v; memcpy(&v, value, sizeof v); return v; }
    }
}

// Stores the low bytes of a cell as an integer of `size` bytes.
static void store_low_bytes(uint64_t cell, void *value, uint32_t size)
{
    const uint8_t v1 = (uint8_t)cell;
    const uint16_t v2 = (uint16_t)cell;
    const uint32_t v4 = (uint32_t)cell;

    memcpy(value, size == 1 ? (const void *)&v1 : size == 2 ? (const void *)&v2 : size == 4 ? (const void *)&v4 : (const void *)&cell, size);
}

static SmcResult get_cell(const Call *c, uint32_t variable, uint64_t *cell)
{
    const int32_t type = smc_machine_variable_type(c->s, c->m, variable);
    uint8_t value[8] = {0};
    double number;
    SmcResult r;

    if (is_float(type)) {
        if ((r = smc_machine_get(c->s, c->m, variable, &number)) == SMC_OK)
            memcpy(cell, &number, sizeof number);
        return r;
    }
    if ((r = smc_machine_read(c->s, c->m, variable, value, size_of_type(type))) == SMC_OK)
        *cell = read_integer(value, type);
    return r;
}

static SmcResult set_cell(const Call *c, uint32_t variable, uint64_t cell)
{
    const int32_t type = smc_machine_variable_type(c->s, c->m, variable);
    uint8_t value[8];
    double number;

    if (is_float(type)) {
        memcpy(&number, &cell, sizeof number);
        return smc_machine_set(c->s, c->m, variable, number);
    }
    store_low_bytes(cell, value, size_of_type(type));
    if (type >= 0 && read_integer(value, type) != cell)         // the value does not fit the type: refused like a number that does not fit
        return SMC_E_SIZE;
    return smc_machine_write(c->s, c->m, variable, value, size_of_type(type));
}

int32_t smclv_get_cells(int32_t machine, const int32_t *variables, uint64_t *cells, int32_t count, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_values(&c, machine, variables, cells, count, message, message_size);

    if (r != SMC_OK)
        return r;
    for (int32_t i = 0; r == SMC_OK && i < count; i++)
        r = get_cell(&c, (uint32_t)variables[i], &cells[i]);
    return finish(&c, r);
}

int32_t smclv_set_cells(int32_t machine, const int32_t *variables, const uint64_t *cells, int32_t count, char *message, int32_t message_size)
{
    Call c;
    SmcResult r = begin_values(&c, machine, variables, cells, count, message, message_size);

    if (r != SMC_OK)
        return r;
    for (int32_t i = 0; r == SMC_OK && i < count; i++)
        if ((r = set_cell(&c, (uint32_t)variables[i], cells[i])) == SMC_E_SIZE)
            return finish_refused(&c, r);
    return finish(&c, r);
}
