// SPDX-License-Identifier: Apache-2.0
// Finds inputs of an application with which one of its machines reaches goals (search.h).  Every step of the search is a tick of all machines.
//
//     SearchApp *a = search_app_new(arena, p, machine, cover);
//     SearchResult *r = search_app_run(a, &options);        // as search_run; scenarios are of the joined Program p
//
// An input is an element that no machine of the application writes, and that some machine reads or has as its @mode.
//
// A goal is impossible in the application if it is impossible for the machine alone, whatever its inputs are: what another machine writes is such an
// input.  What follows from the code of the other machines is not used.
#ifndef SMC_SEARCH_APP_H
#define SMC_SEARCH_APP_H

#include "compiler/search/search.h"

typedef struct SearchApp SearchApp;

// Returns why scenarios cannot express the time of the application, as a clause after "because"; NULL: they can.
const char *search_app_refusal(const Program *joint);
// cover: by machine.
SearchApp *search_app_new(Arena *arena, const Program *joint, size_t machine, Cover *const *cover);
// Searches for the goals of the machine's Cover, once: then the SearchApp has ended.  Scenarios of `o`, and of the result, set variables of the
// joined Program.
SearchResult *search_app_run(SearchApp *a, const SearchOptions *o);
// Sets writable[Var.index] for the inputs of an application.
void search_app_inputs(const Program *joint, bool *writable);

#endif
