// SPDX-License-Identifier: Apache-2.0
// Joins the machines of an application into one Program for its scripts (language.md 8.71 to 8.83): its variables are all elements of the
// state vector, and the locals and the T of each machine; its states are the states of all machines.
#ifndef SMC_JOIN_H
#define SMC_JOIN_H

#include "compiler/sema/check.h"

// `program`: by App.machine, the machine as the scripts run it. Returns NULL after reporting that the application has no machines. Warns if
// several executors have machines.
const Program *join_machines(const CheckContext *c, const App *app, const Program *const *program);

#endif
