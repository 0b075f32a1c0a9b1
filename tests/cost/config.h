// SPDX-License-Identifier: Apache-2.0
// Builds the VM so that it counts the instructions that it executes.
#ifndef TESTS_COST_CONFIG_H
#define TESTS_COST_CONFIG_H

void cost_count_instruction(void);

#define SMVM_ON_INSTRUCTION cost_count_instruction()

#endif
