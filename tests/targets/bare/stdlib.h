// SPDX-License-Identifier: Apache-2.0
#ifndef SM_BARE_STDLIB_H
#define SM_BARE_STDLIB_H

__attribute__((noreturn)) void exit(int status);

#endif
