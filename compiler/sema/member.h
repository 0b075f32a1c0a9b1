// SPDX-License-Identifier: Apache-2.0
// Names of one machine among several in the script of an application: `deploy.T` (language.md 8.77 to 8.79).
#ifndef SMC_MEMBER_H
#define SMC_MEMBER_H

#include "compiler/sema/sema.h"

// Reports a name that needs the name of a machine before it, or that has one and is wrong. `is_state`: it is a section's header. Returns
// false, and reports nothing, if the name is neither.
bool report_member_name(Sema *s, Str name, Span span, bool is_state);
// Reports a declared name that has a dot. Returns false if it has none.
bool report_dotted_declaration(Sema *s, Str name, Span span);

#endif
