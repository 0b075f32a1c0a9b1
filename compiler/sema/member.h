// SPDX-License-Identifier: Apache-2.0
// Names of one machine among several in the script of an application: `deploy.T` (language.md 8.77 to 8.79).
#ifndef SMC_MEMBER_H
#define SMC_MEMBER_H

#include "compiler/sema/sema.h"

// Reports a name that was not found, if it lacks the name of its machine (`T`), or has a machine or member that does not exist (`deploy.x`), or
// has a dot in the script of one machine.  `is_state`: the name is a section's header.  Returns false, and reports nothing, for any other name.
bool report_member_name(Sema *s, Str name, Span span, bool is_state);
// Adds a label and an edit to the message x about `deploy.Main`, if m is the machine `deploy` and Main one of its states: beside `deploy.S` a state
// is written without its machine.
void label_state_of_machine(Sema *s, const Program *m, Str name, Span span, Diag *x);
// Reports a declared name that has a dot. Returns false if it has none.
bool report_dotted_declaration(Sema *s, Str name, Span span);

#endif
