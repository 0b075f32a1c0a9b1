// SPDX-License-Identifier: Apache-2.0
// The flight runtime: everything that an application includes.  Begin with docs/runtime.md.
#ifndef SM_H
#define SM_H

#include "runtime-c/app.h"
#include "runtime-c/event.h"
#include "runtime-c/executor.h"
#include "runtime-c/io.h"
#include "runtime-c/keep.h"
#include "runtime-c/log.h"
#include "runtime-c/machine.h"
#include "runtime-c/statevec.h"
#include "runtime-c/task.h"

#endif
