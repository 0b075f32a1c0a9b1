// SPDX-License-Identifier: Apache-2.0
// Whole runs of a machine on columns: arrays with one value for each step.
#include "compiler/library/library.h"
#include "stdlib/convert.h"

enum { ROWS_PER_CHECK = 1024 };   // rows between two checks for smc_cancel: some microseconds

// A variable of the machine that a column sets or records.
typedef struct Cell {
    uint8_t *at;                  // where the machine stores the variable
    SmType type;
} Cell;

typedef struct ColumnRun {
    LibraryMachine *m;
    uint64_t rows;
    const uint64_t *g;
    uint32_t inputs, outputs;
    const uint32_t *input, *output;
    const double *const *from;
    double *const *to;
    uint32_t *states;
    uint64_t *done;
    Cell *cell;                   // one per input, then one per output
} ColumnRun;

// ---- checking the arguments ----

static SmcResult find_cell(const SmcSession *s, const LibraryMachine *m, uint32_t variable, const void *column, Cell *cell)
{
    const LibraryVariable *v;

    if (variable >= m->variables)
        return library_fail(s, SMC_E_INDEX, NULL);
    if (!column)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    v = &m->variable[variable];
    *cell = (Cell){(v->kind == SMC_VARIABLE_ELEMENT ? m->vector : (uint8_t *)smvm_locals(m->vm)) + v->offset, v->type};
    return SMC_OK;
}

// Finds the cells of all columns, for inputs and then for outputs.  Without rows, columns can be NULL.
static SmcResult find_cells(const SmcSession *s, const ColumnRun *run)
{
    static const double no_rows;
    SmcResult r = SMC_OK;

    for (uint32_t k = 0; r == SMC_OK && k < run->inputs; k++) {
        r = find_cell(s, run->m, run->input[k], run->rows ? run->from[k] : &no_rows, &run->cell[k]);
        if (r == SMC_OK && run->cell[k].at == run->m->vector + run->m->m.g)
            r = library_fail(s, SMC_E_ARGUMENT, "G cannot be an input: it has an array of its own");
        if (r == SMC_OK && library_parameter(run->m, &run->m->variable[run->input[k]]) != UINT32_MAX)
            r = library_fail(s, SMC_E_ARGUMENT, "a parameter cannot be an input: it has one value from start to end");
    }
    for (uint32_t k = 0; r == SMC_OK && k < run->outputs; k++)
        r = find_cell(s, run->m, run->output[k], run->rows ? run->to[k] : &no_rows, &run->cell[run->inputs + k]);
    return r;
}

// Whether the caller has passed an array for everything that it asks to read or write.
static bool has_arrays(const ColumnRun *run)
{
    return (run->rows == 0 || run->g) && (run->inputs == 0 || (run->input && run->from)) && (run->outputs == 0 || (run->output && run->to));
}

// ---- running ----

// Runs the step of one row.  Returns false, and changes nothing, if G would not advance.
static bool run_row(const ColumnRun *run, uint64_t row)
{
    const LibraryMachine *m = run->m;
    const Cell *cell = run->cell;

    if (run->g[row] + 1 <= m->vm->next)           // refuses the largest G, too, because G + 1 wraps to 0
        return false;
    for (uint32_t k = 0; k < run->inputs; k++, cell++)
        sm_store(cell->type, cell->at, run->from[k][row]);
    sm_cell_store(SM_U64, m->vector + m->m.g, run->g[row]);
    smvm_step_decoded(m->decoded, m->vector);
    for (uint32_t k = 0; k < run->outputs; k++, cell++)
        run->to[k][row] = sm_load(cell->type, cell->at);
    if (run->states)
        run->states[row] = smvm_state(m->vm);
    return true;
}

// Runs one step for each row. *run->done counts the finished rows, also when the session is cancelled.
static SmcResult run_rows(SmcSession *s, void *argument)
{
    const ColumnRun *run = argument;

    for (uint64_t row = 0; row < run->rows; row++, ++*run->done) {
        if (row % ROWS_PER_CHECK == 0 && library_is_cancelled(s))
            return library_fail(s, SMC_E_CANCELLED, NULL);
        if (!run_row(run, row))
            return library_fail(s, SMC_E_REFUSED, "G is not above that of the last step");
    }
    return SMC_OK;
}

SmcResult smc_machine_run(SmcSession *s, SmcMachine m, uint64_t rows, const uint64_t *g, uint32_t inputs, const uint32_t *input,
                          const double *const *from, uint32_t outputs, const uint32_t *output, double *const *to, uint32_t *states, uint64_t *done)
{
    ColumnRun run = {library_machine(s, m), rows, g, inputs, outputs, input, output, from, to, states, done, NULL};
    SmcResult r;

    if (!run.m)
        return library_no_machine(s);
    if (!done)
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    *done = 0;
    if (!has_arrays(&run))
        return library_fail(s, SMC_E_ARGUMENT, NULL);
    if (rows > PTRDIFF_MAX / sizeof *g)
        return library_fail(s, SMC_E_SIZE, NULL);
    if ((run.cell = library_alloc(s, ((uint64_t)inputs + outputs) * sizeof *run.cell)) == NULL)
        return library_fail(s, SMC_E_MEMORY, NULL);
    if ((r = find_cells(s, &run)) == SMC_OK)
        r = library_guard(s, run_rows, &run);
    library_release(s, run.cell);
    return r;
}
