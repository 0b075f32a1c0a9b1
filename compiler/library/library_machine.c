// SPDX-License-Identifier: Apache-2.0
// Machines of a session: each a copy of an image, the memory of the VM, and a state vector.
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/library/library.h"
#include "stdlib/convert.h"

// ---- handles ----

// The upper half of the handles of a session, so that another open session refuses them: different addresses have different halves unless
// they are 64 GB apart.
static uint32_t handle_tag(const SmcSession *s) { return (uint32_t)((uintptr_t)s >> 4); }

// Returns where machine m is, or would be inserted, in the session's machines, which are sorted by id (binary search).
static uint32_t position_of(const SmcSession *s, SmcMachine m)
{
    uint32_t from = 0, end = s->machines;

    while (from < end) {
        const uint32_t middle = from + (end - from) / 2;
        if (s->machine[middle]->id < m)
            from = middle + 1;
        else
            end = middle;
    }
    return from;
}

// Returns the session's machine with handle m, or NULL if it is closed or of another session.
LibraryMachine *library_machine(const SmcSession *s, SmcMachine m)
{
    uint32_t at;

    if (!library_is_open(s) || s->machines == 0 || m >> 32 != handle_tag(s))
        return NULL;
    at = position_of(s, m);
    return at < s->machines && s->machine[at]->id == m ? s->machine[at] : NULL;
}

SmcResult library_no_machine(const SmcSession *s) { return library_is_open(s) ? library_fail(s, SMC_E_HANDLE, NULL) : SMC_E_HANDLE; }

static void free_machine(SmcSession *s, LibraryMachine *m)
{
    library_release(s, m->image);
    library_release(s, m->vm);
    library_release(s, m->decoded);
    library_release(s, m->vector);
    library_release(s, m->variable);
    library_release(s, m->names);
    library_release(s, (void *)(uintptr_t)m->state_name);
    library_release(s, m);
}

void library_close_machines(SmcSession *s)
{
    for (uint32_t i = 0; i < s->machines; i++)
        free_machine(s, s->machine[i]);
    library_release(s, s->machine);
    s->machine = NULL;
    s->machines = s->machines_cap = 0;
}

// ---- names ----

// Whether a variable that the image names exists: the verifier does not check names.
static bool is_inside(const SmvmMachine *m, SmvmVariable is, const SmvmLocation *l)
{
    const uint32_t size = is == SMVM_IS_ELEMENT ? m->sv_size : m->locals;

    return (is == SMVM_IS_ELEMENT || is == SMVM_IS_LOCAL) && l->type < SM_TYPE_COUNT && l->offset % sm_type_info[l->type].bytes == 0 &&
           l->offset <= size && sm_type_info[l->type].bytes <= size - l->offset;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const LibraryVariable *)a)->name, ((const LibraryVariable *)b)->name);
}

// Returns the number, from 1, of the output at an offset in the state vector; 0 if no output is stored there.
static uint32_t output_at(const SmvmMachine *m, uint32_t offset)
{
    for (uint32_t i = 0; i < m->outputs; i++)
        if (smvm_output(m, i).offset == offset)
            return i + 1;
    return 0;
}

// Copies a name of the image and a NUL to *at, and returns the copy.
static const char *copy_name(const LibraryMachine *m, SmvmName n, char **at)
{
    char *copy = *at;

    memcpy(copy, m->image + n.at, n.size);
    copy[n.size] = '\0';
    *at += n.size + 1;
    return copy;
}

// Returns the bytes that the names of all states and variables need, with their NULs.
static uint64_t bytes_of_names(const SmvmMachine *m)
{
    uint64_t bytes = smvm_name(m, SMVM_NAME_MACHINE).size + UINT64_C(1);
    SmvmVariable is;
    SmvmLocation l;

    for (uint32_t i = 0; i < smvm_variables(m); i++)
        bytes += smvm_variable(m, i, &is, &l).size + UINT64_C(1);
    for (uint32_t i = 1; i <= m->states; i++)
        bytes += smvm_state_name(m, i).size + UINT64_C(1);
    return bytes;
}

// Lists the variables and states by name.  Returns false if memory runs out.
static bool read_names(SmcSession *s, LibraryMachine *m)
{
    const uint32_t named = smvm_variables(&m->m);
    char *at;

    m->names = library_alloc(s, bytes_of_names(&m->m));
    m->variable = library_alloc(s, (uint64_t)named * sizeof *m->variable);
    m->state_name = library_alloc(s, ((uint64_t)m->m.states + 1) * sizeof *m->state_name);
    if (!m->names || !m->variable || !m->state_name)
        return false;
    at = m->names;
    m->name = copy_name(m, smvm_name(&m->m, SMVM_NAME_MACHINE), &at);
    for (uint32_t i = 0; i < named; i++) {
        SmvmVariable is;
        SmvmLocation l;
        const SmvmName n = smvm_variable(&m->m, i, &is, &l);
        LibraryVariable *v = &m->variable[m->variables];
        if (n.size == 0 || !is_inside(&m->m, is, &l))
            continue;
        *v = (LibraryVariable){copy_name(m, n, &at), l.type, is == SMVM_IS_ELEMENT ? SMC_VARIABLE_ELEMENT : SMC_VARIABLE_LOCAL, l.offset, 0};
        v->output = is == SMVM_IS_ELEMENT ? output_at(&m->m, l.offset) : 0;
        m->variables++;
    }
    qsort(m->variable, m->variables, sizeof *m->variable, compare_names);
    m->state_name[0] = "";
    for (uint32_t i = 1; i <= m->m.states; i++)
        m->state_name[i] = copy_name(m, smvm_state_name(&m->m, i), &at);
    m->has_names = m->m.states > 0 && m->state_name[1][0] != '\0';
    return true;
}

// ---- opening ----

// Clears the machine's state vector and starts the machine in `state`.
SmcResult library_start_machine(LibraryMachine *m, uint32_t state)
{
    const SmvmVector vector = {m->vector, m->m.sv_size, m->m.layout};

    memset(m->vector, 0, m->m.sv_size);
    return smvm_init(m->vm, smvm_ram_size(&m->m), &m->m, &vector, state) == SM_OK ? SMC_OK : SMC_E_INDEX;
}

// Fills in a machine whose image has been copied.
static SmcResult prepare_machine(SmcSession *s, LibraryMachine *m, uint32_t number)
{
    SmvmVerdict why;

    if (smvm_verify(m->image, m->image_size, &why) != 0)
        return library_fail(s, SMC_E_IMAGE, smvm_rule_text(why.rule));
    if (!smvm_machine(m->image, number, &m->m))
        return library_fail(s, SMC_E_INDEX, "the image has no machine of this number");
    m->vm = library_alloc(s, smvm_ram_size(&m->m));
    m->vector = library_alloc(s, m->m.sv_size);
    m->decoded = library_alloc(s, smvm_decoded_size(&m->m));
    if (!m->vm || !m->vector || !m->decoded || !read_names(s, m))
        return library_fail(s, SMC_E_MEMORY, NULL);
    library_start_machine(m, 1);
    if (smvm_decode(&m->decoded, m->decoded, smvm_decoded_size(&m->m), &m->m, m->vm, m->vector) != SM_OK)
        return library_fail(s, SMC_E_IMAGE, NULL);
    return SMC_OK;
}

static SmcResult open_machine(SmcSession *s, const void *image, uint64_t size, uint32_t number, SmcMachine *id)
{
    LibraryMachine *m = library_alloc(s, sizeof *m);
    LibraryMachine **more;
    SmcResult r;

    if (!m)
        return library_fail(s, SMC_E_MEMORY, NULL);
    memset(m, 0, sizeof *m);
    if ((more = library_grow(s, s->machine, s->machines, &s->machines_cap, sizeof *more)) != NULL)
        s->machine = more;
    if (!more || (m->image = (uint8_t *)library_copy(s, image, size)) == NULL) {
        free_machine(s, m);
        return library_fail(s, SMC_E_MEMORY, NULL);
    }
    m->image_size = (uint32_t)size;
    if ((r = prepare_machine(s, m, number)) != SMC_OK) {
        free_machine(s, m);
        return r;
    }
    *id = m->id = (uint64_t)handle_tag(s) << 32 | ++s->next_machine;
    s->machine[s->machines++] = m;
    return SMC_OK;
}

SmcResult smc_image_machine_count(SmcSession *s, const void *image, uint64_t size, uint32_t *count)
{
    SmvmVerdict why;
    SmvmMachine m;
    uint32_t n = 0;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!image || !count)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (size > SMVM_IMAGE_MAX)
        return library_fail(s, SMC_E_SIZE, NULL);
    if (smvm_verify(image, (uint32_t)size, &why) != 0)
        return library_fail(s, SMC_E_IMAGE, smvm_rule_text(why.rule));
    while (smvm_machine(image, n, &m))
        n++;
    *count = n;
    return SMC_OK;
}

SmcResult smc_machine_open_image(SmcSession *s, const void *image, uint64_t size, uint32_t number, SmcMachine *m)
{
    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!image || !m)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (size > SMVM_IMAGE_MAX || s->next_machine == UINT32_MAX)
        return library_fail(s, SMC_E_SIZE, NULL);
    return open_machine(s, image, size, number, m);
}

// Builds the image of a compiled machine, with names.
static SmcResult build_image(SmcSession *s, void *argument)
{
    const uint32_t source = *(uint32_t *)argument;
    const ImageOptions with_names = {true, NULL};
    LibraryImage made;
    Buf image;
    IrMachine *ir;

    library_begin_layer(s);
    s->compiler.locals = LOCALS_SWAPPED;
    ir = session_ir(&s->compiler, library_compiled(s, source)->program, s->of.o.opt_level);
    buf_init(&image, &s->compiler.arena);
    if (!session_image(&s->compiler, &ir, 1, &with_names, &image)) {
        library_fail(s, SMC_E_SOURCE, s->compiler.diags.list.n ? s->compiler.diags.list.at[0]->text : NULL);
        library_drop_layer(s);
        return SMC_E_SOURCE;
    }
    made = (LibraryImage){library_copy(s, image.at, image.n), image.n};
    library_drop_layer(s);
    if (!made.bytes)
        return library_fail(s, SMC_E_MEMORY, NULL);
    s->of.image[source] = made;
    return SMC_OK;
}

SmcResult smc_machine_open(SmcSession *s, uint32_t source, SmcMachine *m)
{
    const CompiledSource *of;
    SmcResult r;

    if (!library_is_open(s))
        return SMC_E_HANDLE;
    if (!m)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (!s->of.is_compiled)
        return library_fail(s, SMC_E_STATE, NULL);
    if ((of = library_compiled(s, source)) == NULL || s->of.in.at[s->of.input[source] - 1].kind != FILE_SM)
        return library_fail(s, SMC_E_INDEX, "there is no machine of this number");
    if (!of->program)
        return library_fail(s, SMC_E_STATE, "the machine has errors");
    if (!s->of.image[source].bytes && (r = library_guard(s, build_image, &source)) != SMC_OK)
        return r;
    return smc_machine_open_image(s, s->of.image[source].bytes, s->of.image[source].size, 0, m);
}

SmcResult smc_machine_close(SmcSession *s, SmcMachine m)
{
    LibraryMachine *own = library_machine(s, m);
    uint32_t at;

    if (!own)
        return library_no_machine(s);
    at = position_of(s, m);
    memmove(s->machine + at, s->machine + at + 1, (s->machines - at - 1) * sizeof *s->machine);
    s->machines--;
    free_machine(s, own);
    return SMC_OK;
}

// ---- running ----

SmcResult smc_machine_start(SmcSession *s, SmcMachine m, uint32_t state)
{
    LibraryMachine *own = library_machine(s, m);

    if (!own)
        return library_no_machine(s);
    if (state < 1 || state > own->m.states)
        return library_fail(s, SMC_E_INDEX, "there is no state of this number");
    return library_start_machine(own, state);
}

SmcResult smc_machine_step(SmcSession *s, SmcMachine m, uint64_t g)
{
    LibraryMachine *own = library_machine(s, m);
    uint64_t before;

    if (!own)
        return library_no_machine(s);
    before = sm_cell_load(SM_U64, own->vector + own->m.g);
    sm_cell_store(SM_U64, own->vector + own->m.g, g);
    if (smvm_step_decoded(own->decoded, own->vector) == SM_OK)
        return SMC_OK;
    sm_cell_store(SM_U64, own->vector + own->m.g, before);
    return library_fail(s, SMC_E_REFUSED, "G is not above that of the last step");
}

// ---- states ----

const char *smc_machine_name(const SmcSession *s, SmcMachine m)
{
    const LibraryMachine *own = library_machine(s, m);

    return own ? own->name : "";
}

uint32_t smc_machine_state(const SmcSession *s, SmcMachine m)
{
    const LibraryMachine *own = library_machine(s, m);

    return own ? smvm_state(own->vm) : 0;
}

uint32_t smc_machine_state_count(const SmcSession *s, SmcMachine m)
{
    const LibraryMachine *own = library_machine(s, m);

    return own ? own->m.states : 0;
}

const char *smc_machine_state_name(const SmcSession *s, SmcMachine m, uint32_t state)
{
    const LibraryMachine *own = library_machine(s, m);

    return own && state >= 1 && state <= own->m.states ? own->state_name[state] : "";
}

uint32_t smc_machine_state_marks(const SmcSession *s, SmcMachine m, uint32_t state)
{
    const LibraryMachine *own = library_machine(s, m);

    if (!own || state < 1 || state > own->m.states)
        return 0;
    return (own->m.safe_at && smvm_state_is_safe(&own->m, state) ? SMC_MARK_SAFE : 0u) | (smvm_state_is_abort(&own->m, state) ? SMC_MARK_ABORT : 0u) |
           (smvm_state_allows_swap(&own->m, state) ? SMC_MARK_SWAP : 0u);
}

uint64_t smc_machine_time(const SmcSession *s, SmcMachine m)
{
    const LibraryMachine *own = library_machine(s, m);

    return own ? smvm_time(own->vm) : 0;
}

// ---- variables ----

static const LibraryVariable *variable_of(const SmcSession *s, SmcMachine m, uint32_t variable)
{
    const LibraryMachine *own = library_machine(s, m);

    return own && variable < own->variables ? &own->variable[variable] : NULL;
}

uint32_t smc_machine_variable_count(const SmcSession *s, SmcMachine m)
{
    const LibraryMachine *own = library_machine(s, m);

    return own ? own->variables : 0;
}

SmcResult smc_machine_find(const SmcSession *s, SmcMachine m, const char *name, uint32_t *variable)
{
    const LibraryMachine *own = library_machine(s, m);
    LibraryVariable key;
    const LibraryVariable *found;

    if (!own)
        return library_no_machine(s);
    if (!name || !variable)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    key.name = name;
    found = bsearch(&key, own->variable, own->variables, sizeof key, compare_names);
    if (!found)
        return library_fail(s, SMC_E_INDEX, NULL);
    *variable = (uint32_t)(found - own->variable);
    return SMC_OK;
}

const char *smc_machine_variable_name(const SmcSession *s, SmcMachine m, uint32_t variable)
{
    const LibraryVariable *v = variable_of(s, m, variable);

    return v ? v->name : "";
}

int32_t smc_machine_variable_type(const SmcSession *s, SmcMachine m, uint32_t variable)
{
    const LibraryVariable *v = variable_of(s, m, variable);

    return v ? (int32_t)v->type : -1;
}

int32_t smc_machine_variable_kind(const SmcSession *s, SmcMachine m, uint32_t variable)
{
    const LibraryVariable *v = variable_of(s, m, variable);

    return v ? v->kind : -1;
}

uint32_t smc_machine_variable_offset(const SmcSession *s, SmcMachine m, uint32_t variable)
{
    const LibraryVariable *v = variable_of(s, m, variable);

    return v ? v->offset : 0;
}

int32_t smc_machine_variable_stored(const SmcSession *s, SmcMachine m, uint32_t variable)
{
    const LibraryMachine *own = library_machine(s, m);
    const LibraryVariable *v = variable_of(s, m, variable);

    if (!v || v->kind != SMC_VARIABLE_ELEMENT)
        return 0;
    if (v->offset == own->m.s)
        return smvm_stored_state(own->vm);
    return v->output && smvm_stored(own->vm, v->output - 1);
}

// Stores where the value of a variable is.
static SmcResult find_value(const SmcSession *s, SmcMachine m, uint32_t variable, SmType *type, uint8_t **at)
{
    const LibraryMachine *own = library_machine(s, m);
    const LibraryVariable *v = variable_of(s, m, variable);

    if (!own)
        return library_no_machine(s);
    if (!v)
        return library_fail(s, SMC_E_INDEX, NULL);
    *type = v->type;
    *at = (v->kind == SMC_VARIABLE_ELEMENT ? own->vector : (uint8_t *)smvm_locals(own->vm)) + v->offset;
    return SMC_OK;
}

SmcResult smc_machine_get(const SmcSession *s, SmcMachine m, uint32_t variable, double *value)
{
    SmType type;
    uint8_t *at;
    const SmcResult r = find_value(s, m, variable, &type, &at);

    if (r != SMC_OK)
        return r;
    if (!value)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    *value = sm_load(type, at);
    return SMC_OK;
}

// Returns the number of the parameter that a variable is; UINT32_MAX: the variable is no parameter.
uint32_t library_parameter(const LibraryMachine *own, const LibraryVariable *v)
{
    SmvmParameter p;

    for (uint32_t i = 0; v->kind == SMC_VARIABLE_LOCAL && smvm_parameter(&own->m, i, &p); i++)
        if (p.offset == v->offset)
            return i;
    return UINT32_MAX;
}

// Returns SMC_OK if the variable can have the value: a parameter only before the first step, and within its range.
static SmcResult check_setting(const SmcSession *s, SmcMachine m, uint32_t variable, double value)
{
    const LibraryMachine *own = library_machine(s, m);
    const uint32_t parameter = library_parameter(own, variable_of(s, m, variable));
    uint8_t refusal;

    if (parameter == UINT32_MAX)
        return SMC_OK;
    if (own->vm->next != 0)
        return library_fail(s, SMC_E_ARGUMENT, "a parameter is set before the first step");
    refusal = smvm_judge_parameter(&own->m, parameter, value);
    return refusal ? library_fail(s, SMC_E_ARGUMENT, smvm_refusal_text(refusal)) : SMC_OK;
}

SmcResult smc_machine_set(SmcSession *s, SmcMachine m, uint32_t variable, double value)
{
    SmType type;
    uint8_t *at;
    SmcResult r = find_value(s, m, variable, &type, &at);

    if (r == SMC_OK)
        r = check_setting(s, m, variable, value);
    if (r == SMC_OK)
        sm_store(type, at, value);
    return r;
}

// Stores where the value of a variable is, if `value`, of `size` bytes, can be a copy of the variable.
// Returns SMC_E_SIZE if the variable's type has another size.
static SmcResult find_value_to_copy(const SmcSession *s, SmcMachine m, uint32_t variable, const void *value, uint32_t size, uint8_t **at)
{
    SmType type;
    const SmcResult r = find_value(s, m, variable, &type, at);

    if (r != SMC_OK)
        return r;
    if (!value)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    return size == sm_type_info[type].bytes ? SMC_OK : library_fail(s, SMC_E_SIZE, NULL);
}

SmcResult smc_machine_read(const SmcSession *s, SmcMachine m, uint32_t variable, void *value, uint32_t size)
{
    uint8_t *at;
    const SmcResult r = find_value_to_copy(s, m, variable, value, size, &at);

    if (r == SMC_OK)
        memcpy(value, at, size);
    return r;
}

// Returns the number in memory, also where it is NaN, which the language reads as 0.
static double number_in(SmType type, const void *value)
{
    const uint64_t cell = sm_cell_load(type, value);

    return type == SM_F64 ? sm_from_bits(cell) : type == SM_F32 ? (double)sm_f32_from_bits((uint32_t)cell) : sm_load(type, value);
}

SmcResult smc_machine_write(SmcSession *s, SmcMachine m, uint32_t variable, const void *value, uint32_t size)
{
    uint8_t *at;
    SmcResult r = find_value_to_copy(s, m, variable, value, size, &at);

    if (r == SMC_OK)
        r = check_setting(s, m, variable, number_in(variable_of(s, m, variable)->type, value));
    if (r == SMC_OK)
        memcpy(at, value, size);
    return r;
}

// ---- sizes ----

uint64_t smc_machine_info(const SmcSession *s, SmcMachine m, int32_t what)
{
    const LibraryMachine *own = library_machine(s, m);

    if (!own)
        return 0;
    switch (what) {
    case SMC_INFO_VECTOR: return own->m.sv_size;
    case SMC_INFO_LAYOUT: return own->m.layout;
    case SMC_INFO_MEMORY: return smvm_ram_size(&own->m);
    case SMC_INFO_DECODED: return smvm_decoded_size(&own->m);
    case SMC_INFO_IMAGE: return own->image_size;
    case SMC_INFO_LONGEST_STEP: return smvm_longest_step(&own->m);
    }
    return 0;
}

void *smc_machine_vector(SmcSession *s, SmcMachine m)
{
    const LibraryMachine *own = library_machine(s, m);

    return own ? own->vector : NULL;
}
