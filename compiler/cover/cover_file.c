// SPDX-License-Identifier: Apache-2.0
// Coverage as files: counts that later runs add, JSON, and the tracefile format of lcov.
//
// A file of counts has the name and the identity of its machine, and then the count of each place, in the order of Cover.place. That of an
// application has this for each of its machines:
//
//     smc-coverage 1
//     machine tank 0123456789abcdef
//     places 3
//     12
//     0
//     7
#include <inttypes.h>
#include <string.h>

#include "compiler/analysis/transitions.h"
#include "compiler/base/json.h"
#include "compiler/base/path.h"
#include "compiler/cover/cover.h"
#include "compiler/script/script.h"

static const char head[] = "smc-coverage 1\nmachine ";

static uint32_t line_of(const CoverPlace *p) { return source_position(p->where.src, p->where.at).line; }

// ---- counts ----

void cover_write_data(const Cover *c, Buf *out)
{
    buf_printf(out, "%s%s %016" PRIx64 "\nplaces %lu\n", head, c->p->name->text, c->identity, (unsigned long)c->place.n - 1);
    for (uint32_t i = 1; i < c->place.n; i++)
        buf_printf(out, "%" PRIu64 "\n", c->hits[i]);
}

typedef struct Reader { const char *at, *end; } Reader;

static bool read_text(Reader *r, const char *text)
{
    const size_t n = strlen(text);

    if ((size_t)(r->end - r->at) < n || memcmp(r->at, text, n) != 0)
        return false;
    r->at += n;
    return true;
}

// Reads a decimal number and the end of its line.  A number that is too large becomes UINT64_MAX.
static bool read_number(Reader *r, uint64_t *x)
{
    const char *begin = r->at;

    *x = 0;
    for (; r->at < r->end && *r->at >= '0' && *r->at <= '9'; r->at++)
        *x = *x > (UINT64_MAX - 9) / 10 ? UINT64_MAX : *x * 10 + (uint64_t)(*r->at - '0');
    return r->at > begin && read_text(r, "\n");
}

static const char *list_names(Cover *const *machine, size_t machines)
{
    const char *list = format_in(machine[0]->arena, "'%s'", machine[0]->p->name->text);

    for (size_t i = 1; i < machines; i++)
        list = format_in(machine[0]->arena, "%s or '%s'", list, machine[i]->p->name->text);
    return list;
}

// Reads the line with the name and identity of a machine.  Sets *which to its index in `machine`; otherwise returns a phrase that says what is wrong.
static const char *read_machine_line(Cover *const *machine, size_t machines, Reader *r, size_t *which)
{
    Arena *arena = machine[0]->arena;
    const char *name = r->at;
    size_t n;

    while (r->at < r->end && *r->at != ' ' && *r->at != '\n')
        r->at++;
    n = (size_t)(r->at - name);
    if (!read_text(r, " "))
        return "is damaged: the name of its machine is missing";
    for (*which = 0; *which < machines; ++*which) {
        const Str own = machine[*which]->p->name;
        if (n == own->len && memcmp(name, own->text, n) == 0)
            break;
    }
    if (*which == machines)
        return format_in(arena, "has the coverage of the machine '%.*s', not of %s", (int)n, name, list_names(machine, machines));
    if (!read_text(r, format_in(arena, "%016" PRIx64 "\n", machine[*which]->identity)))
        return format_in(arena, "has the coverage of another version of '%.*s': run its scripts again", (int)n, name);
    return NULL;
}

// The counts of one machine that a file contains; `count` is by place.
typedef struct CountsRead { Cover *of; uint64_t *count; } CountsRead;

// Reads the counts of one machine.  Returns NULL, or a phrase that says what is wrong.
static const char *read_counts(Cover *const *machine, size_t machines, Reader *r, CountsRead *out)
{
    uint64_t places;
    size_t which;
    const char *wrong;

    if (!read_text(r, head))
        return "is no file that --coverage-data has written";
    if ((wrong = read_machine_line(machine, machines, r, &which)) != NULL)
        return wrong;
    out->of = machine[which];
    out->count = ARENA_ARRAY(out->of->arena, uint64_t, out->of->place.n);
    if (!read_text(r, "places ") || !read_number(r, &places) || places != out->of->place.n - 1)
        return "is damaged: its number of places is wrong";
    for (uint32_t i = 1; i < out->of->place.n; i++)
        if (!read_number(r, &out->count[i]))
            return "is damaged: it has too few counts";
    return NULL;
}

static void add_counts(const CountsRead *read)
{
    Cover *c = read->of;

    for (uint32_t i = 1; i < c->place.n; i++)
        c->hits[i] = c->hits[i] > UINT64_MAX - read->count[i] ? UINT64_MAX : c->hits[i] + read->count[i];
}

const char *cover_add_data(Cover *const *machine, size_t machines, const char *text, size_t n)
{
    Reader r = {text, text + n};
    VEC(CountsRead) read = {NULL, 0, 0};

    do {
        CountsRead one;
        const char *wrong = read_counts(machine, machines, &r, &one);
        if (wrong)
            return read.n && r.at < r.end && *r.at >= '0' && *r.at <= '9' ? "is damaged: it has too many counts" : wrong;
        vec_push(machine[0]->arena, &read, one);
    } while (r.at < r.end);
    for (uint32_t i = 0; i < read.n; i++)
        add_counts(&read.at[i]);
    return NULL;
}

// ---- JSON ----

static void write_json_place(const Cover *c, uint32_t i, Buf *out)
{
    const CoverPlace *p = &c->place.at[i];
    const LineCol at = source_position(p->where.src, p->where.at);

    buf_printf(out, "{\"kind\":\"%s\",\"line\":%lu,\"column\":%lu,\"text\":", cover_kind_name[p->kind], (unsigned long)at.line,
               (unsigned long)at.col);
    json_put_string(out, source_text(c->arena, p->span));
    if (p->kind == COVER_TRANSITION)
        buf_printf(out, ",\"from\":\"%s\",\"to\":\"%s\"", p->from->name->text, p->to->name->text);
    if (p->kind == COVER_GUARD || p->kind == COVER_CONDITION)
        buf_printf(out, ",\"outcome\":%s", p->value ? "true" : "false");
    if (p->kind == COVER_STATE)
        buf_printf(out, ",\"event\":\"%s\"", p->value ? "entered" : "left");
    if (p->kind == COVER_PARAMETER) {
        buf_str(out, ",\"value\":");
        format_cell_shortest(out, p->parameter->type, p->cell);
    }
    buf_printf(out, ",\"count\":%" PRIu64, c->hits[i]);
    if (p->impossible) {
        buf_str(out, ",\"impossible\":");
        json_put_string(out, p->impossible);
    }
    buf_char(out, '}');
}

void cover_write_json(const Cover *c, Buf *out)
{
    buf_printf(out, "{\"smc-coverage\":1,\"machine\":\"%s\",\"identity\":\"%016" PRIx64 "\",\"file\":", c->p->name->text, c->identity);
    json_put_string(out, path_portable_name(c->p->src->name));
    buf_str(out, ",\n\"totals\":{");
    for (int k = 0; k < COVER_KIND_COUNT; k++) {
        const CoverTotal t = cover_total(c, (CoverKind)k);
        buf_printf(out, "%s\"%s\":{\"covered\":%lu,\"possible\":%lu,\"impossible\":%lu}", k ? "," : "", cover_kind_name[k], (unsigned long)t.covered,
                   (unsigned long)t.possible, (unsigned long)t.impossible);
    }
    buf_str(out, "},\n\"places\":[\n");
    for (uint32_t i = 1; i < c->place.n; i++) {
        write_json_place(c, i, out);
        buf_str(out, i + 1 < c->place.n ? ",\n" : "\n");
    }
    buf_str(out, "]}\n");
}

// ---- lcov: states are functions, statements are lines, outcomes of decisions are branches ----

static void write_lcov_states(const Cover *c, Buf *out)
{
    unsigned long found = 0, hit = 0;

    for (uint32_t i = 1; i < c->place.n; i++)
        if (c->place.at[i].kind == COVER_STATE && c->place.at[i].value)
            buf_printf(out, "FN:%lu,%s\n", (unsigned long)line_of(&c->place.at[i]), c->place.at[i].from->name->text);
    for (uint32_t i = 1; i < c->place.n; i++)
        if (c->place.at[i].kind == COVER_STATE && c->place.at[i].value) {
            buf_printf(out, "FNDA:%" PRIu64 ",%s\n", c->hits[i], c->place.at[i].from->name->text);
            found++;
            hit += c->hits[i] > 0;
        }
    buf_printf(out, "FNF:%lu\nFNH:%lu\n", found, hit);
}

static void write_lcov_branch(const Cover *c, uint32_t i, uint32_t number, bool evaluated, unsigned long *found, unsigned long *hit, Buf *out)
{
    const CoverPlace *p = &c->place.at[i];

    buf_printf(out, "BRDA:%lu,%lu,%lu,", (unsigned long)line_of(p), (unsigned long)p->where.at, (unsigned long)number);
    buf_printf(out, evaluated ? "%" PRIu64 "\n" : "-\n", c->hits[i]);
    ++*found;
    *hit += c->hits[i] > 0;
}

// Returns the first place about the same parameter as place i.  All places about a parameter are adjacent.
static uint32_t first_value_of(const Cover *c, uint32_t i)
{
    while (c->place.at[i - 1].parameter == c->place.at[i].parameter)
        i--;
    return i;
}

// Writes the outcomes of decisions, which are in pairs: true, false.  Impossible ones are left out.  The values of a parameter are branches at
// its declaration.
static void write_lcov_branches(const Cover *c, Buf *out)
{
    unsigned long found = 0, hit = 0;

    for (uint32_t i = 1; i < c->place.n; i++) {
        const CoverPlace *p = &c->place.at[i];
        const bool evaluated = c->hits[i] || (i + 1 < c->place.n && c->hits[i + 1]);
        if (p->kind == COVER_PARAMETER)
            write_lcov_branch(c, i, i - first_value_of(c, i), true, &found, &hit, out);
        if (p->kind != COVER_GUARD || !p->value)
            continue;
        for (uint32_t k = 0; k < 2; k++)
            if (!c->place.at[i + k].impossible)
                write_lcov_branch(c, i + k, k, evaluated, &found, &hit, out);
    }
    buf_printf(out, "BRF:%lu\nBRH:%lu\n", found, hit);
}

// Writes, for each line of the source that contains statements, the highest count of executions among these statements.
static void write_lcov_lines(const Cover *c, Buf *out)
{
    const uint32_t lines = c->p->src->lines;
    uint64_t *count = ARENA_ARRAY(c->arena, uint64_t, lines + 1);
    bool *has = arena_alloc(c->arena, lines + 1);
    unsigned long found = 0, hit = 0;

    for (uint32_t i = 1; i < c->place.n; i++)
        if (c->place.at[i].kind == COVER_STATEMENT && !c->place.at[i].impossible) {
            const uint32_t line = line_of(&c->place.at[i]);
            has[line] = true;
            count[line] = c->hits[i] > count[line] ? c->hits[i] : count[line];
        }
    for (uint32_t line = 1; line <= lines; line++)
        if (has[line]) {
            buf_printf(out, "DA:%lu,%" PRIu64 "\n", (unsigned long)line, count[line]);
            found++;
            hit += count[line] > 0;
        }
    buf_printf(out, "LF:%lu\nLH:%lu\n", found, hit);
}

void cover_write_lcov(const Cover *c, Buf *out)
{
    buf_printf(out, "TN:smc\nSF:%s\n", c->p->src->name);
    write_lcov_states(c, out);
    write_lcov_branches(c, out);
    write_lcov_lines(c, out);
    buf_str(out, "end_of_record\n");
}
