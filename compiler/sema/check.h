// SPDX-License-Identifier: Apache-2.0
// The checker: AST to typed program.  Reports every error once, without errors that only follow from it, and returns NULL if there was one.
#ifndef SMC_CHECK_H
#define SMC_CHECK_H

#include "compiler/diag/diag.h"
#include "compiler/sema/application.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/network.h"
#include "compiler/sema/program.h"
#include "compiler/sema/requirements.h"
#include "compiler/syntax/ast.h"

typedef struct CheckContext {
    Arena *arena;
    StrPool *strings;
    Diags *diags;
    bool proposes_guards;     // reports comparisons with G in a script that a guard by time can replace
    bool has_requirements;    // the machine has files of requirements, and their check reports the definitions that nothing uses
} CheckContext;

StateVec *check_state_vector(CheckContext *c, const AstFile *sv);

// How a machine that is used under another name differs from its file.
typedef struct MachineInstance {
    Str name;                 // names its program and the files generated from it; NULL: the file's stem does
    Span span;                // position of its name in the application; or zeroed
    const AstBinding *binding;        // the elements to which its names are bound (config.md 10.29)
    size_t bindings;
    bool lost;                // a binding is missing, because an error was reported
} MachineInstance;

// `sv` may be NULL: then the machine's own [state_vector] section is the whole vector.  `written_outside` names the locals that
// code outside the machine (a state script) writes.  Read-only locals among them are treated as variables, not constants.  Pass
// NULL if no code outside writes any.  `instance`: NULL, or how the machine differs from its file; then `sv` is not NULL.
Program *check_machine(CheckContext *c, const AstFile *sm, StateVec *sv, const Map *written_outside, const MachineInstance *instance);

// Checks a script of n files: those that it includes in the order of their sections, and the script itself as the last.
Script *check_script(CheckContext *c, const AstFile *const *file, size_t n, const Program *program);
// Like check_script, for files without syntax errors whose items are not in memory.  `outline`: the trees of parse_script, without items.
// Parses each source again, with only some of its items in memory at a time: the items are in `items`, the rest of the syntax tree is in
// `tree`.  The caller frees both arenas.
Script *check_script_source(CheckContext *c, Arena *tree, Arena *items, const AstFile *const *outline, size_t n, const Program *program);

// Checks the requirements of n files of a machine (check_rq.c).
Requirements *check_requirements(CheckContext *c, const AstFile *const *file, size_t n, const Program *p);
// Warn of marks @req, in the machine and in a script, with ids that no requirement has.
void check_requirement_marks(CheckContext *c, const Requirements *r);
void check_requirements_of_script(CheckContext *c, const Requirements *r, const Script *script);

// Binds pins to elements of `sv`.
IoMap *check_io(CheckContext *c, const AstFile *io, const StateVec *sv);

// Binds the messages of a .net to elements of `sv`.
Network *check_net(CheckContext *c, const AstFile *net, const StateVec *sv);

// Lists the files that an application names.  The caller opens them before check_app.
void app_list_files(Arena *arena, const AstFile *app, AppFiles *out);
// `sv`, `pins`, `net` and a machine's program are NULL if that file has errors, which are already reported.  Everything else is still checked.
App *check_app(CheckContext *c, const AstFile *app, const StateVec *sv, const IoMap *pins, const Network *net, const AppFiles *files);

// Adds the names that the script assigns to `names`, a set: each name maps to itself. The caller passes it to check_machine as written_outside.
void script_add_written_names(const AstFile *ss, Map *names);
void script_add_names_of_section(const AstSection *section, Map *names);      // adds the names of the columns of [data]
void script_add_names_of_item(const AstStmt *item, Map *names);
// Returns how much G advances per step in the script, where the machine counts time in `unit`; 0 if the script has no valid delta_t.
uint64_t script_delta_t(const AstFile *ss, TimeUnit unit);

// Computes offsets, sizes and hash of a state vector whose elements and regions are complete (vector_layout.c).
void layout_state_vector(StateVec *sv);

#endif
